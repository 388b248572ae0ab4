#pragma once

#include "ndframe/run/run.hpp"

namespace ndframe
{

/// Fills in what the summary says of the bodies of a solved run: energies, extremes, loads, reactions. Collective.
void completeBodies(RunSummary& summary, const Run& run, const Comm& comm);

} // namespace ndframe

#pragma once

#include "ndframe/run/run.hpp"

namespace ndframe
{

/// Fills in what the summary says of the bodies of a solved run: energies, extremes, loads, reactions. The ranks share
/// the cells. strainLimit: what cells are counted above. Collective.
void completeBodies(RunSummary& summary, const Run& run, double strainLimit, const Comm& comm);

} // namespace ndframe

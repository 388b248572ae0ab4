#pragma once

#include "ndframe/run/run.hpp"

namespace ndframe
{

/// What the summary says of the bodies of a solved run: energies, extremes, loads, reactions. Collective.
void completeBodies(Run& run, const Comm& comm);

} // namespace ndframe

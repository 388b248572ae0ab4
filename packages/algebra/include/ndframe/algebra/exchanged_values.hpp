#pragma once

#include "ndframe/algebra/comm.hpp"

namespace ndframe
{

/// values: per rank what it gets from this one. Returns per rank what this one gets. Collective.
std::vector<Vector> exchangedValues(const std::vector<Vector>& values, const Comm& comm);

} // namespace ndframe

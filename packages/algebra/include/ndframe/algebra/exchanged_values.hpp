#pragma once

#include <string>

#include "ndframe/algebra/comm.hpp"

namespace ndframe
{

/// values: per rank what it gets from this one. Returns per rank what this one gets. Collective.
std::vector<Vector> exchangedValues(const std::vector<Vector>& values, const Comm& comm);

/// The same with bytes. Limit: 2 GB for each rank to send and to get.
std::vector<std::string> exchangedBytes(const std::vector<std::string>& bytes, const Comm& comm);

} // namespace ndframe

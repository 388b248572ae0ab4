#pragma once

#include <vector>

#include "ndframe/algebra/index_map.hpp"
#include "ndframe/algebra/shared_values.hpp"

namespace ndframe
{

/// The rank that owns each of some numbers of a map; every number must have an owner. Asks a list of owners that all
/// ranks hold together, a block of the numbers each: none has the size of the map. Collective.
std::vector<int> ownersOf(const std::vector<IndexMap::Global>& numbers, const IndexMap& map, const Comm& comm);

/// Values at a map: those of a rank's ghosts come from their owners. Collective.
SharedValues sharedGhosts(const IndexMap& map, const Comm& comm);

} // namespace ndframe

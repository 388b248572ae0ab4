#pragma once

#include <vector>

#include "ndframe/algebra/block_matrix.hpp"
#include "ndframe/fem/node_map.hpp"

namespace ndframe
{

/// The pattern of the owned rows (values zero): two nodes are coupled when they share a cell.
BlockMatrix makeSparsity(const NodeMap& nodes, const std::vector<int>& ownedNodes);

} // namespace ndframe

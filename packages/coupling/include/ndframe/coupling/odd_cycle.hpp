#pragma once

#include <utility>
#include <vector>

namespace ndframe
{

/// A cycle of an odd number of nodes in the graph 0 .. numNodes - 1 with these edges, in the order of a walk round it;
/// empty where two colours suffice. Linear in nodes and edges.
std::vector<int> oddCycle(int numNodes, const std::vector<std::pair<int, int>>& edges);

} // namespace ndframe

#pragma once

#include <array>
#include <vector>

namespace ndframe
{

/// Owner rank of every node: METIS k-way partition of the graph in which the nodes of a cell are all neighbours.
/// Deterministic (fixed seed). `parts` == 1 gives zeros without calling METIS.
/// cellNodes: nodesPerCell * numCells node numbers. weights: per node, what parts should have equal sums of; empty:
/// one.
std::vector<int> partitionNodes(const std::vector<int>& cellNodes, int nodesPerCell, int numNodes, int parts,
                                const std::vector<int>& weights = {});

/// Owner rank of every point: halves (or the share of the ranks on each side) along the longest extent, again and
/// again, so that parts have as many points each, to one. Points at one place in this direction go by their numbers.
std::vector<int> partitionByPlace(const std::vector<std::array<double, 3>>& points, int parts);

} // namespace ndframe

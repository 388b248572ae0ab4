#pragma once

#include <vector>

namespace ndframe
{

/// Owner rank of every node: METIS k-way partition of the graph in which the nodes of a cell are all neighbours.
/// Deterministic (fixed seed). `parts` == 1 gives zeros without calling METIS.
/// cellNodes: nodesPerCell * numCells node numbers. weights: per node, what parts should have equal sums of; empty:
/// one.
std::vector<int> partitionNodes(const std::vector<int>& cellNodes, int nodesPerCell, int numNodes, int parts,
                                const std::vector<int>& weights = {});

} // namespace ndframe

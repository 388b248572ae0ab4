#pragma once

#include <vector>

#include "tpetra_system.hpp"

namespace ndframe
{

Teuchos::RCP<const Teuchos::Comm<int>> teuchosComm(const Comm& comm);

/// `perNode` consecutive numbers for each node.
Teuchos::RCP<const TpetraMap> mapOf(const std::vector<int>& nodes, int perNode,
                                    const Teuchos::RCP<const Teuchos::Comm<int>>& comm);

/// Nodes as this rank numbers them: its own first, then those of other ranks in the order in which they come.
struct LocalNodes
{
  LocalNodes(const std::vector<int>& own, int numNodes);
  /// The number of a node here, a new one if it has none.
  int number(int node);

  std::vector<int> nodes;
  std::vector<int> local; ///< node -> its number, -1 for nodes that this rank does not see
};

/// The nodes of this rank's columns.
LocalNodes columnNodes(const BlockMatrix& K);

} // namespace ndframe

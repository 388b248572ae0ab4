#pragma once

#include <vector>

#include <Tpetra_Import.hpp>

#include "ndframe/iterative/krylov_library.hpp"
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

/// Values of a rank's own dofs with those of other ranks that it needs, and the way back. Counts what it sends.
class Halo
{
public:
  Halo(const Teuchos::RCP<const TpetraMap>& own, const Teuchos::RCP<const TpetraMap>& needed); ///< collective

  /// needed := the values of their owners.
  void fetch(const TpetraVectors& own, TpetraVectors& needed) const;
  /// own += the values of all that need them.
  void add(const TpetraVectors& needed, TpetraVectors& own) const;
  const Traffic& traffic() const { return traffic_; } ///< of this rank, so far

private:
  Tpetra::Import<> import_;
  Traffic fetch_, add_; ///< one of each
  mutable Traffic traffic_;
};

/// The nodes of this rank's columns.
LocalNodes columnNodes(const BlockMatrix& K);

} // namespace ndframe

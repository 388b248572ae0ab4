#pragma once

#include <vector>

#include <Tpetra_Import.hpp>

#include "ndframe/iterative/krylov_library.hpp"
#include "tpetra_system.hpp"

namespace ndframe
{

Teuchos::RCP<const Teuchos::Comm<int>> teuchosComm(const Comm& comm);

/// `perNode` consecutive numbers for each node that this rank owns, in the order of its own numbers. They are not the
/// nodes' numbers: those of a rank follow those of the rank before, so that Tpetra needs no table to find them.
Teuchos::RCP<const TpetraMap> ownedMap(const IndexMap& nodes, int perNode,
                                       const Teuchos::RCP<const Teuchos::Comm<int>>& comm);
/// The same for all nodes that this rank holds: the ghosts follow, by the numbers that their owners give them.
/// Collective.
Teuchos::RCP<const TpetraMap> heldMap(const IndexMap& nodes, int perNode,
                                      const Teuchos::RCP<const Teuchos::Comm<int>>& comm);

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

} // namespace ndframe

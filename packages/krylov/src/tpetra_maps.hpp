#pragma once

#include <vector>

#include "tpetra_system.hpp"

namespace ndframe
{

Teuchos::RCP<const Teuchos::Comm<int>> teuchosComm(const Comm& comm);

/// `perNode` consecutive numbers for each node that this rank owns, in the order of its own numbers.
Teuchos::RCP<const TpetraMap> ownedMap(const IndexMap& nodes, int perNode,
                                       const Teuchos::RCP<const Teuchos::Comm<int>>& comm);
/// The same for all nodes that this rank holds: the ghosts follow.
Teuchos::RCP<const TpetraMap> heldMap(const IndexMap& nodes, int perNode,
                                      const Teuchos::RCP<const Teuchos::Comm<int>>& comm);

} // namespace ndframe

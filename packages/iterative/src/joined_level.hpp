#pragma once

#include "ndframe/algebra/joined_system.hpp"
#include "ndframe/iterative/linear_level.hpp"

namespace ndframe
{

/// The vertices of several bodies, one after another, as one system: E^T P^T K P E with the kept dofs at vertices
/// following unknowns, and all that a preconditioner wants to know of it.
struct JoinedLevel
{
  /// keptDofs: per kept dof of all bodies its dof here, -1 where it does not belong to a vertex. springs: per kept dof,
  /// added to the diagonal of the unknown that stands there. Collective.
  JoinedLevel(const std::vector<std::unique_ptr<LinearLevel>>& levels, const std::vector<RankProblem::Global>& keptDofs,
              const JoinedRows& rows, const Vector& springs, const Comm& comm);

  BlockMatrix matrix;
  RankProblem problem; ///< of `matrix`: this must stay where it is

  JoinedLevel(const JoinedLevel&) = delete;
  JoinedLevel& operator=(const JoinedLevel&) = delete;
};

} // namespace ndframe

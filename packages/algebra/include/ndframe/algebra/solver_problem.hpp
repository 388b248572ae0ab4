#pragma once

#include <vector>

#include "ndframe/algebra/neumann_solver.hpp"

namespace ndframe
{

/// The dofs that are not fixed, numbered in ascending order: the unknowns of the direct solvers.
struct FreeDofs
{
  explicit FreeDofs(const std::vector<DofRole>& roles); ///< roles: one per dof

  int size() const { return int(dofs.size()); } ///< number of unknowns

  std::vector<int> dofs;   ///< free number -> dof
  std::vector<int> number; ///< dof -> free number, -1 for fixed dofs
};

/// Asserts the shapes of a problem. Throws InputError when all dofs are fixed, and SingularBody when a combination of
/// the near null space that needs no energy moves neither a fixed nor a kept dof: nothing holds the body, and K_ii is
/// singular whatever its pivots look like.
void checkProblem(const SolverProblem& problem, const Comm& comm);

/// The combinations of the near null space that move no fixed dof and need no energy. `held` by pivotRows().
FreeMotions freeMotions(const SolverProblem& problem, const Comm& comm);

} // namespace ndframe

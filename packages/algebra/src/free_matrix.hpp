#pragma once

#include "cholmod_factor.hpp"
#include "ndframe/algebra/solver_problem.hpp"

namespace ndframe
{

/// K on the free dofs.
UpperTriangle freeUpperTriangle(const SolverProblem& problem, const FreeDofs& free);

/// Adds to the diagonal of the kept dofs.
void shiftKept(UpperTriangle& A, const SolverProblem& problem, const FreeDofs& free, const Vector& shift);

/// The mean diagonal entry of the kept dofs: a shift of their size. 0 without any.
double meanKeptDiagonal(const SolverProblem& problem, const Comm& comm);

} // namespace ndframe

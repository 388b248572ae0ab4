#pragma once

#include "cholmod_factor.hpp"
#include "solver_problem.hpp"

namespace ndframe
{

/// K on the free dofs, `shift` added to the diagonal of the kept ones.
UpperTriangle freeUpperTriangle(const SolverProblem& problem, const FreeDofs& free, double shift);

/// The mean diagonal entry of the kept dofs: a shift of their size. 0 without any.
double meanKeptDiagonal(const SolverProblem& problem, const Comm& comm);

} // namespace ndframe

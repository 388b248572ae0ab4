#pragma once

#include "ndframe/algebra/linear_solver.hpp"

namespace ndframe
{

/// The entries of `Linear Solver/Type` = Cholmod (one rank) and Mumps (any number), with documentation and parameters.
void registerCholmod(Registry<LinearSolver>& registry);
void registerMumps(Registry<LinearSolver>& registry); ///< adds Mumps

/// With their defaults.
std::unique_ptr<LinearSolver> makeCholmod();
std::unique_ptr<LinearSolver> makeMumps(); ///< with its defaults

} // namespace ndframe

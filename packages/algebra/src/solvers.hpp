#pragma once

#include "ndframe/algebra/linear_solver.hpp"

namespace ndframe
{

/// One function per component file, all called by registerLinearSolvers().
void registerCholmod(Registry<LinearSolver>& registry);
void registerMumps(Registry<LinearSolver>& registry);
void registerMultigrid(Registry<LinearSolver>& registry);
void registerKrylov(Registry<LinearSolver>& registry);

/// Those that "Automatic" chooses from, with their defaults.
std::unique_ptr<LinearSolver> makeCholmod();
std::unique_ptr<LinearSolver> makeMumps();
std::unique_ptr<LinearSolver> makeMultigrid();

} // namespace ndframe

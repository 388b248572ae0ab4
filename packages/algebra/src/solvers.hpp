#pragma once

#include "ndframe/algebra/linear_solver.hpp"

namespace ndframe
{

/// One function per component file, all called by registerLinearSolvers().
void registerCholmod(Registry<LinearSolver>& registry);
void registerMumps(Registry<LinearSolver>& registry);
void registerMultigrid(Registry<LinearSolver>& registry);
void registerKrylov(Registry<LinearSolver>& registry);

/// The two that "Automatic" chooses from.
std::unique_ptr<LinearSolver> makeCholmod();
std::unique_ptr<LinearSolver> makeMumps();

} // namespace ndframe

#pragma once

#include "ndframe/algebra/linear_solver.hpp"

namespace ndframe
{

/// One function per component file, all called by registerLinearSolvers().
void registerCholmod(Registry<LinearSolver>& registry);
void registerMumps(Registry<LinearSolver>& registry);
void registerMultigrid(Registry<LinearSolver>& registry);
void registerKrylov(Registry<LinearSolver>& registry);

/// Those that "Automatic" chooses from; what is not given has its default.
std::unique_ptr<LinearSolver> makeCholmod();
std::unique_ptr<LinearSolver> makeMumps();
std::unique_ptr<LinearSolver> makeMultigrid(int maxIterations);

/// `first`, and where a solve of it ends without a solution (NotConverged, SingularBody) `second` from then on. Counts
/// "solvers given up".
std::unique_ptr<LinearSolver> makeWithSecondChoice(std::unique_ptr<LinearSolver> first,
                                                   std::unique_ptr<LinearSolver> second);

} // namespace ndframe

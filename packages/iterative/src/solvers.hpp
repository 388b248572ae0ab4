#pragma once

#include "ndframe/algebra/linear_solver.hpp"

namespace ndframe
{

void registerMultigrid(Registry<LinearSolver>& registry);
void registerKrylov(Registry<LinearSolver>& registry);

/// What is not given has its default.
std::unique_ptr<LinearSolver> makeMultigrid(int maxIterations);

/// `first`, and where a solve of it ends without a solution (NotConverged, SingularBody) `second` from then on. Counts
/// "solvers given up".
std::unique_ptr<LinearSolver> makeWithSecondChoice(std::unique_ptr<LinearSolver> first,
                                                   std::unique_ptr<LinearSolver> second);

} // namespace ndframe

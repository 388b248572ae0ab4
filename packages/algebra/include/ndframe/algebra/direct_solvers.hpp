#pragma once

#include "ndframe/algebra/linear_solver.hpp"

namespace ndframe
{

void registerCholmod(Registry<LinearSolver>& registry);
void registerMumps(Registry<LinearSolver>& registry);

/// With their defaults.
std::unique_ptr<LinearSolver> makeCholmod();
std::unique_ptr<LinearSolver> makeMumps();

} // namespace ndframe

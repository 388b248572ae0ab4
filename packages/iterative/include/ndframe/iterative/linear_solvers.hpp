#pragma once

#include "ndframe/algebra/linear_solver.hpp"

namespace ndframe
{

/// "Automatic" (Cholmod on one rank, Mumps on several, Multigrid for large solids), "Cholmod", "Mumps", "Multigrid",
/// "Krylov".
void registerLinearSolvers(Registry<LinearSolver>& registry);

} // namespace ndframe

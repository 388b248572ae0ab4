#pragma once

#include "ndframe/recovery/stress_recovery.hpp"

namespace ndframe
{

/// "Star": the correction is a sum of one field per vertex, each of least energy on the vertex's star (theory.md);
/// block Gauss-Seidel sweeps over the stars then lower the energy of the sum. Parameters Degree, Sweeps.
void registerStarRecovery(Registry<StressRecovery>& registry);

std::unique_ptr<StressRecovery> makeStarRecovery(int degree, int sweeps);

} // namespace ndframe

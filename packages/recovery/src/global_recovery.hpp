#pragma once

#include "ndframe/recovery/stress_recovery.hpp"

namespace ndframe
{

/// "Global" (parameters Degree, Steps): solids only. Stars are only brought into balance; then all of a body's
/// tractions together are moved towards the least energy by conjugate gradients.
void registerGlobalRecovery(Registry<StressRecovery>& registry);

std::unique_ptr<StressRecovery> makeGlobalRecovery(int degree, int steps);

} // namespace ndframe

#pragma once

#include "ndframe/recovery/stress_recovery.hpp"

namespace ndframe
{

/// "Automatic" (parameters Degree, Sweeps): Star in the plane; Global in space, half the least gain a sweep.
void registerAutomaticRecovery(Registry<StressRecovery>& registry);

} // namespace ndframe

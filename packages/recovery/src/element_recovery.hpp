#pragma once

#include "ndframe/recovery/stress_recovery.hpp"

namespace ndframe
{

/// "Element".
void registerElementRecovery(Registry<StressRecovery>& registry);

} // namespace ndframe

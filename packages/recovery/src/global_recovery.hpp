#pragma once

#include "ndframe/recovery/stress_recovery.hpp"
#include "stress_descent.hpp"

namespace ndframe
{

/// "Global" (parameters Degree, Least Gain, Steps): solids only. Stars are only brought into balance; then all of a
/// body's tractions together are moved towards the least energy by conjugate gradients, as long as that lowers the
/// bound.
void registerGlobalRecovery(Registry<StressRecovery>& registry);

/// Of Global and Automatic, unless asked otherwise (docs/performance.md, "How many steps").
inline constexpr DescentEnd usualEnd{100, 0.01};

std::unique_ptr<StressRecovery> makeGlobalRecovery(int degree, const DescentEnd& end);

} // namespace ndframe

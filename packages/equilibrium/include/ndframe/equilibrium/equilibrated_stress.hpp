#pragma once

#include "ndframe/equilibrium/reference_stress.hpp"
#include "ndframe/equilibrium/stress_correction.hpp"

namespace ndframe
{

/// The correction c alone on one cell.
SplitStress correctionStress(const BodyModel& body, const StressCorrection& correction, int cell);

/// sigma^ = K eps(u~) + c on one cell.
SplitStress equilibratedStress(const BodyModel& body, const Vector& displacement, const StressCorrection& correction,
                               int cell);

} // namespace ndframe

#pragma once

#include <functional>

#include "ndframe/equilibrium/reference_stress.hpp"
#include "ndframe/equilibrium/stress_correction.hpp"

namespace ndframe
{

/// The correction c alone on one cell.
SplitStress correctionStress(const BodyModel& body, const StressCorrection& correction, int cell);

/// sigma^ = K eps(u~) + c on one cell.
SplitStress equilibratedStress(const BodyModel& body, const Vector& displacement, const StressCorrection& correction,
                               int cell);

/// Cells of visitStresses() at a time.
constexpr int visitedTogether = 64;

/// The stresses of some cells in the order given, many at a time; displacement: null for the correction alone. A stress
/// holds during its visit.
void visitStresses(const BodyModel& body, const Vector* displacement, const StressCorrection& correction,
                   const std::vector<int>& cells, const std::function<void(int, const SplitStress&)>& visit);

} // namespace ndframe

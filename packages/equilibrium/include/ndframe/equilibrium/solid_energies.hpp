#pragma once

#include "ndframe/equilibrium/stress_correction.hpp"

namespace ndframe
{

/// int sigma^ : C^-1 sigma^ over some cells of a solid, sigma^ = K eps(u) + c with the bubbles of least energy of c;
/// displacement: null for the correction alone. A sum of squares. What a cell gets does not depend on the others.
Vector solidEnergies(const BodyModel& body, const Vector* displacement, const StressCorrection& correction,
                     const std::vector<int>& cells);

} // namespace ndframe

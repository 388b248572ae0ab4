#pragma once

#include "ndframe/equilibrium/stress_correction.hpp"

namespace ndframe
{

/// Per cell the squared distance in the complementary energy norm between the equilibrated stress and the stress of an
/// admissible displacement,
///
///   |K eps(u~) + c - K eps(u)|_E^2 = |c|^2 + 2 <c, eps(v)> + |eps(v)|^2,   v = u~ - u,
///   <c, eps(v)> = - int div c . v + int_dE c n . v,
///
/// (42) without the contact term. Computed as the energy of the polynomial c + K eps(v): a sum of squares, so large
/// terms do not cancel. difference: v, numNodes * dim, global axes; null for zero.
Vector cellDistances(const BodyModel& body, const StressCorrection& correction, const Vector* difference);

/// The same of some cells of a solid, per one of `cells`.
Vector solidDistances(const BodyModel& body, const StressCorrection& correction, const Vector* difference,
                      const std::vector<int>& cells);

} // namespace ndframe

#pragma once

#include "ndframe/recovery/reference_stress.hpp"
#include "ndframe/recovery/stress_correction.hpp"

namespace ndframe
{

/// The energy of a correction in one cell as a function of its data, bubbles eliminated:
/// int c : C^-1 c = x^T A x for balanced x = (tractions, loads) in global axes. Relative round-off grows with the
/// fourth power of the cell's aspect ratio: good for finding a stress, not for measuring it (cellDistances).
DenseMatrix cellEnergyMatrix(const ReferenceStress& reference, const CellMap& map, const Elasticity& law);

/// Per cell the squared distance in the complementary energy norm between the equilibrated stress and the stress of an
/// admissible displacement,
///
///   |K eps(u~) + c - K eps(u)|_E^2 = |c|^2 + 2 <c, eps(v)> + |eps(v)|^2,   v = u~ - u,
///   <c, eps(v)> = - int div c . v + int_dE c n . v,
///
/// (42) without the contact term. Computed as the energy of the polynomial c + K eps(v): a sum of squares, so large
/// terms do not cancel. difference: v, numNodes * dim, global axes; null for zero.
Vector cellDistances(const BodyModel& body, const StressCorrection& correction, const Vector* difference);

/// sigma^ = K eps(u~) + c on one cell.
SplitStress equilibratedStress(const BodyModel& body, const Vector& displacement, const StressCorrection& correction,
                               int cell);

} // namespace ndframe

#pragma once

#include "ndframe/equilibrium/reference_stress.hpp"
#include "ndframe/equilibrium/stress_correction.hpp"

namespace ndframe
{

/// The energy of a correction in one cell as a function of its data, bubbles eliminated:
/// int c : C^-1 c = x^T A x for balanced x = (tractions, loads) in global axes. Relative round-off grows with the
/// fourth power of the cell's aspect ratio: good for finding a stress, not for measuring it (cellDistances).
DenseMatrix cellEnergyMatrix(const ReferenceStress& reference, const CellMap& map, const Elasticity& law);

} // namespace ndframe

#pragma once

#include "ndframe/equilibrium/stress_correction.hpp"

namespace ndframe
{

/// The classical residual indicator (Babuska and Rheinboldt 1978; Verfuerth 1996): squared contributions of the cells
/// to
///
///   eta^2 = 1/k [ sum_E h_E^2 |b + div sigma_h|_E^2 + sum_f h_f |J_f|_f^2 ],
///
/// J_f the jump of sigma_h n on inner facets, p - sigma_h n on boundary facets (p = 0 where nothing acts, the given
/// traction on contact facets, only directions without support), h the diameters, k the smallest eigenvalue of the
/// stiffness in Mandel form (2 mu for isotropic materials). Inner facets count half for each of their cells.
///
/// An energy. NOT a bound: a constant of order one that depends on the shapes of the cells is missing.
/// field: as for recovery; data with the degree of its traction.
CellValues residualIndicator(const BodyModel& body, const StaticData& data, const FieldInput& field);

} // namespace ndframe

#pragma once

#include "ndframe/admissibility/contact_traction.hpp"

namespace ndframe
{

/// What shows that a traction presses everywhere: t_N <= 0 on a facet of unit measure with the moments T if no entry of
/// signConditions T is positive.
///
/// On edges the Bernstein coefficients on both halves (de Casteljau 1959), the first half first, ascending from the
/// first vertex. They ask for less than those of the whole edge: the quadratic b0 (1-s)^2 + 2 b1 s (1-s) + b2 s^2 may
/// have b1 up to min(|b0|, |b2|), as next to a singular corner, where the pressure falls steeply. On triangles those of
/// the whole (bernsteinOfMoments).
DenseMatrix signConditions(int dim, int degree);

/// Largest of the signConditions of t_N over all patches, per measure: not above 0 means t_N <= 0 everywhere. Never
/// above largestBernstein().
double largestSign(const ContactTraction& traction, const std::vector<ContactPatch>& patches);

} // namespace ndframe

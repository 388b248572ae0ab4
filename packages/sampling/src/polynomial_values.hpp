#pragma once

#include <array>

#include "ndframe/sampling/sampling_rules.hpp"

namespace ndframe
{

/// By coordinate: those of a simplex's vertices in a box.
using BoxCorners = std::array<std::array<double, 4>, 3>;

/// The values of a polynomial in `dim` coordinates at the points of a rule on a triangle or tetrahedron, as many as its
/// coordinates are padded to. coefficients: of xi^i eta^j zeta^k with i + j + k <= degree, k by k and j by j (in a
/// plane k = 0).
void polynomialValues(const double* coefficients, int degree, int dim, const BoxCorners& corners,
                      const SamplingRule& sampling, double* result);

} // namespace ndframe

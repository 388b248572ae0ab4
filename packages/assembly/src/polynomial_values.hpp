#pragma once

#include "sampling_rules.hpp"

namespace ndframe
{

/// A triangle's corners in the coordinates of a box.
struct TriangleCorners
{
  double xi[3], eta[3];
};

/// The values of a polynomial at the points of a rule on a triangle, as many as its coordinates are padded to.
/// coefficients: of xi^i eta^j with i + j <= degree, j by j.
void polynomialValues(const double* coefficients, int degree, const TriangleCorners& corners,
                      const SamplingRule& sampling, double* result);

} // namespace ndframe

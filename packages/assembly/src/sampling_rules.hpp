#pragma once

#include <vector>

#include "ndframe/algebra/dense.hpp"
#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{

/// A Gauss rule with a test of whether its points tell everything about a function.
struct SamplingRule
{
  QuadratureRule rule;
  /// Points just inside the corners, barycentric: a jump between a corner and the next point shows there. Not the
  /// corners themselves, they may be singular.
  std::vector<double> corners;
  /// Rest at the points and corners (rows) of the projection onto polynomials of the degree that the rule can multiply
  /// with the test polynomials; columns: values at the points, then at the corners.
  DenseMatrix rest;
};

/// The rules that are tried one after the other, of degree 6, 8, 12 and, in one and two dimensions, 18.
using SamplingLadder = std::vector<SamplingRule>;

/// The ladder on the simplex of dimension `dim`, built on first use.
const SamplingLadder& samplingLadder(int dim);

} // namespace ndframe

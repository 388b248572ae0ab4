#pragma once

#include <vector>

#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{

/// A Gauss rule and the degree of the polynomials that it integrates exactly with polynomials of degree 4 and with
/// themselves.
struct SamplingRule
{
  QuadratureRule rule;
  int kept = 0;
};

/// The rules that are tried one after the other, of degree 6, 8, 12 and, in one and two dimensions, 18.
const std::vector<SamplingRule>& samplingLadder(int dim);

} // namespace ndframe

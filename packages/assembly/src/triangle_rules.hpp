#pragma once

#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{

/// There is one of degree 4, 5, 6, 8, 9, 10 and 12.
bool hasSymmetricTriangleRule(int degree);

/// The symmetric rules of Dunavant (1985) with 6, 7, 12, 16, 19, 25 and 33 points, all weights positive and all points
/// inside; about half of the points of simplexRule.
QuadratureRule symmetricTriangleRule(int degree);

} // namespace ndframe

#pragma once

#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{

/// There is one of degree 5, 7 and 9.
bool hasSymmetricTetrahedronRule(int degree);

/// Symmetric rules with 14, 35 and 59 points, all weights positive and all points inside; a quarter of the points of
/// simplexRule. Found by Newton's method on the moment equations of symmetric polynomials, from random points; the
/// numbers of points are those of Witherden and Vincent (2015).
QuadratureRule symmetricTetrahedronRule(int degree);

} // namespace ndframe

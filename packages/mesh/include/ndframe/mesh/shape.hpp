#pragma once

#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// Shape of the triangle a, b, c (two coordinates each): 4 sqrt(3) area / (sum of the squared edges).
///
/// 1 if it is equilateral, 0.87 half a square, towards 0 if it is flat, negative if it is inverted (Bank and Smith
/// 1997). The smallest angle alpha satisfies sqrt(3) sin(alpha) / (2 - cos(alpha)) >= shape. Units and position do not
/// matter.
double triangleShape(const double* a, const double* b, const double* c);

/// The smallest shape of a triangle mesh's cells; 1 for no cells.
double worstShape(const Mesh& mesh);

} // namespace ndframe

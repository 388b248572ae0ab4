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

/// Shape of the tetrahedron of these four points (three coordinates each), the mean ratio:
/// 12 (3 volume)^(2/3) / (sum of the squared edges).
///
/// 1 if it is regular, 0.756 a sixth of a cube (Kuhn), 0.84 its corner, towards 0 if it is flat, negative if it is
/// inverted (Liu and Joe 1994). Units and position do not matter.
double tetrahedronShape(const double* a, const double* b, const double* c, const double* d);

/// The smallest shape of a mesh's cells; 1 for no cells.
double worstShape(const Mesh& mesh);

} // namespace ndframe

#pragma once

#include "ndframe/admissibility/smallest_stiffness.hpp"
#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// Constants of data oscillation. For d orthogonal to rigid motions on a cell E or on its facet f,
///
///   |int_E d . v| <= C_E |d|_E |eps(v)|_E,     |int_f d . v| <= C_f |d|_f |eps(v)|_E.
///
/// In the plane v loses a rigid motion: its mean and its mean rotation. What is left, w, has |w|_E <= C_P |grad w|_E
/// with C_P = diameter / pi (Payne and Weinberger 1960, E convex) and |grad w|_E^2 <= K |eps(v)|_E^2 (Korn), K = 1 + 2
/// / beta^2 in the plane, where beta >= rho / (sqrt 2 R) (1 + sqrt(1 - (rho / R)^2))^(-1/2) bounds the inf-sup constant
/// of the divergence for a set in a ball of radius R that is star-shaped with respect to the concentric ball of radius
/// rho (Costabel and Dauge 2015): the incentre, the inradius and the distance of the farthest vertex. On the facet
/// |w|_f^2 <= |f| / |E| (|w|_E^2 + 2 h / dim |w|_E |grad w|_E), h the longest edge to the opposite vertex.
///
/// In space the constants are those of Kuhn's tetrahedron (0, e1, e1 + e2, e1 + e2 + e3), found by a finite eigenvalue
/// problem and a proof (theory.md, section 2), carried over by the map F of the cell's vertices in the best of their 24
/// orders: C_E <= |F|^2 |F^-1| C_0, C_f^2 <= |F|^4 |F^-1|^2 |f| / (|f_Kuhn| |det F|) C_1^2 with spectral norms.
/// shareBeyondPolynomials: what is left of C_f for a d that is also orthogonal to the polynomials of a degree on f;
/// sqrt(6 / 11.5) in space from degree 2 on, where only Kuhn's tetrahedron knows the difference; otherwise 1. Limits:
/// pessimistic for flat cells, as the fourth power of the shape enters.
double cellOscillationConstant(const Mesh& mesh, int cell);
double facetOscillationConstant(const Mesh& mesh, Facet facet);
double shareBeyondPolynomials(int dim, int degree);

} // namespace ndframe

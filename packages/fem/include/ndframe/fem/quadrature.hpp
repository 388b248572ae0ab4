#pragma once

#include <vector>

namespace ndframe
{

/// Points in barycentric coordinates with weights that add up to 1 (multiply by the measure of the simplex).
struct QuadratureRule
{
  int dim = 0;                 ///< of the simplex
  std::vector<double> lambda;  ///< (dim + 1) per point
  std::vector<double> weights; ///< one per point

  int size() const { return int(weights.size()); } ///< number of points
  /// The dim + 1 coordinates of a point.
  const double* point(int q) const { return lambda.data() + std::size_t(q) * std::size_t(dim + 1); }
};

/// A rule on the simplex of dimension 1, 2 or 3 that is exact for polynomials up to `degree`, all weights positive and
/// all points inside. Degree <= 2 uses the symmetric rule with dim + 1 points, higher degrees the collapsed Gauss
/// product.
QuadratureRule simplexRule(int dim, int degree);

/// A rule for triangles (dim 2) or tetrahedra (3) with about as few points as are known: of Xiao and Gimbutas (2010) up
/// to degree 30 and 15, with symmetric points in triangles; beyond, the collapsed product of Gauss-Jacobi rules. All
/// weights are positive and all points inside. Tables and roots are Basix's.
QuadratureRule compactRule(int dim, int degree);

} // namespace ndframe

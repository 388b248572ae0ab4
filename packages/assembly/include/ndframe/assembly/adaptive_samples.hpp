#pragma once

#include <array>
#include <functional>
#include <vector>

#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{

/// A function on a simplex by its values where Gauss rules on pieces of the simplex integrate it.
///
/// sum_i weights_i values_i P(lambda_i) is the mean value of f P for polynomials P of degree <= 4, to about
/// 1e-13 of the function's scale (1e-12 next to a jump). Every integral of a load (load vector, moments, oscillation)
/// uses the same samples, so that they agree to round-off whatever the load.
struct Samples
{
  struct Piece
  {
    std::array<double, 16> corners{}; ///< barycentric coordinates in the simplex of its dim + 1 corners
    double fraction = 1.0;            ///< of the simplex's measure
    int first = 0;                    ///< its first point; its points follow each other
    const QuadratureRule* rule = nullptr;
  };
  std::vector<Piece> pieces;
  QuadratureRule rule;        ///< the points of all pieces, barycentric in the simplex; weights add up to 1
  std::vector<double> values; ///< components per point
  double scale = 0.0;         ///< largest value here or elsewhere: what is small is small against it
  /// 0 when the rules settled; else what they leave uncertain of mean values, relative to the scale.
  double uncertainty = 0.0;
};

/// Fills `value` at a point of space.
using PointFunction = std::function<void(const double* x, double* value)>;

/// Rules of degree 6, 8, 12 and (not in tetrahedra) 18 are tried until the function at their points, and just inside
/// the corners, is a polynomial that the rule integrates exactly; a piece on which none is good enough is bisected, the
/// worst first, up to 128 pieces of an edge, 64 of a triangle, 4 of a tetrahedron. A jump inside an edge is resolved to
/// round-off, one inside a triangle is not (uncertainty). The points are a test, not a proof: a peak between them stays
/// unseen.
///
/// dim: of the simplex; vertices: dim + 1 points with `space` coordinates; f: `components` finite values.
/// scale: the function's size elsewhere, which round-off is relative to (0 when unknown).
Samples sampleAdaptively(int dim, const double* const* vertices, int space, int components, double scale,
                         const PointFunction& f);

/// The function that is constant on the simplex, by a rule of degree 2: exact for loads on elements of order 2.
Samples sampleConstant(int dim, const std::vector<double>& value);

} // namespace ndframe

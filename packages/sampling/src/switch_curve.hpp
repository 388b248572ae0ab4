#pragma once

#include <optional>

#include "line_polynomial.hpp"
#include "simplex_piece.hpp"

namespace ndframe
{

/// Where a function s vanishes inside a triangle, as polynomials over the direction in which s does not change most.
///
/// With nu the gradient of s at the centroid, made a unit vector, and tau across it, points are c + xi tau + eta nu.
/// Shown by enclosures: D s . nu >= m > 0 on the triangle, so that s = 0 is a graph over xi; on every strip of the
/// triangle between two xi, |s| <= r along a polynomial eta(xi), or s has one sign along the side where it is least to
/// within r. So s has the sign that the strips say but where |eta - eta(xi)| <= r / m.
class SwitchCurve
{
public:
  /// degree: of the polynomials that rules are exact for. allowed: of the simplex, the share whose side may stay open.
  /// Nothing where that cannot be shown.
  static std::optional<SwitchCurve> find(const ExpressionTree& s, const SimplexGeometry& simplex,
                                         const Samples::Piece& triangle, int degree, double allowed);

  /// The side where s has a sign, as a rule in barycentric coordinates of the simplex; weights add up to the side's
  /// share of the simplex. Points that are nearer to the curve than its error are counted in `open`.
  QuadratureRule side(double sign) const;
  /// The share of the simplex where points may be on the other side, or may have been taken for it.
  double open() const { return open_; }

private:
  class Finder;

  /// The part of the triangle over xi = middle + t half, between two polynomials, with one sign of s.
  struct Strip
  {
    double middle = 0.0, half = 0.0;
    LinePolynomial lower, upper; ///< in t
    double sign = 0.0;
  };

  SwitchCurve() = default;
  void addPoints(const Strip& strip, QuadratureRule& rule) const;

  int degree_ = 0;
  QuadratureRule across_; ///< between two polynomials
  std::vector<Strip> strips_;
  /// Barycentric coordinates in the simplex: of the centroid, and their changes with xi and eta.
  std::array<double, 3> origin_{}, alongXi_{}, alongEta_{};
  double density_ = 0.0; ///< share of the simplex per d xi d eta
  double open_ = 0.0;
};

} // namespace ndframe

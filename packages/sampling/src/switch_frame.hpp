#pragma once

#include <optional>

#include "simplex_piece.hpp"

namespace ndframe
{

/// Coordinates (xi, eta) of a triangle about its centroid, eta along the gradient of a function s there, along which s
/// is shown to increase all over the triangle.
class SwitchFrame
{
public:
  using Point = std::array<double, 2>;

  /// Nothing where s is not shown to increase.
  static std::optional<SwitchFrame> on(const ExpressionTree& s, const SimplexGeometry& simplex,
                                       const Samples::Piece& triangle);

  const std::array<Point, 3>& corners() const { return corners_; }
  double leastSlope() const { return leastSlope_; } ///< lower bound of the derivative of s with eta
  double density() const { return density_; }       ///< share of the simplex per d xi d eta

  double value(const ExpressionTree& s, double xi, double eta) const;
  /// An upper bound of sign * s on a segment.
  double largest(const ExpressionTree& s, double sign, Point from, Point to) const;
  /// The points (middle + t half, eta(t)).
  Curve curve(double middle, double half, const std::vector<double>& eta) const;
  /// Barycentric coordinates in the simplex: of the centroid, and their changes with xi and eta.
  void barycentric(const SimplexGeometry& simplex, const Samples::Piece& triangle, std::array<double, 3>& origin,
                   std::array<double, 3>& alongXi, std::array<double, 3>& alongEta) const;

private:
  SwitchFrame() = default;
  Region::Point place(double xi, double eta) const;

  Region::Point centroid_{}, xi_{}, eta_{}; ///< the latter of length 1
  std::array<Point, 3> corners_{};
  double leastSlope_ = 0.0, density_ = 0.0;
};

} // namespace ndframe

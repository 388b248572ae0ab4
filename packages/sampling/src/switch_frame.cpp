#include "switch_frame.hpp"

#include <cmath>

namespace ndframe
{
namespace
{

using Position = Region::Point;

Position combined(const Position& a, double factor, const Position& b)
{
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

double dotProduct(const Position& a, const Position& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double norm(const Position& a)
{
  return std::sqrt(dotProduct(a, a));
}

Position scaled(const Position& a, double factor)
{
  return {factor * a[0], factor * a[1], factor * a[2]};
}

/// The gradient of s at a point, in the plane of two orthonormal directions.
Position gradient(const ExpressionTree& s, const Position& x, const Position& first, const Position& second)
{
  const auto slope = [&](const Position& direction) { return enclose(s, {{x}, {direction}}, -1, 1).slope.middle(); };
  return combined(scaled(first, slope(first)), slope(second), second);
}

} // namespace

std::optional<SwitchFrame> SwitchFrame::on(const ExpressionTree& s, const SimplexGeometry& simplex,
                                           const Samples::Piece& triangle)
{
  const auto x = simplex.corners(triangle);
  SwitchFrame frame;
  frame.centroid_ = scaled(combined(combined(x[0], 1.0, x[1]), 1.0, x[2]), 1.0 / 3.0);
  const Position a = combined(x[1], -1.0, x[0]), b = combined(x[2], -1.0, x[0]);
  const Position first = scaled(a, 1.0 / norm(a)), across = combined(b, -dotProduct(b, first), first);
  const Position second = scaled(across, 1.0 / norm(across));
  const Position slope = gradient(s, frame.centroid_, first, second);
  const double steepness = norm(slope), area = 0.5 * norm(a) * norm(across);
  if (!(steepness > 0.0 && std::isfinite(steepness) && area > 0.0))
    return {};
  frame.eta_ = scaled(slope, 1.0 / steepness);
  frame.xi_ = combined(scaled(first, dotProduct(frame.eta_, second)), -dotProduct(frame.eta_, first), second);
  frame.leastSlope_ = enclose(s, {x, {frame.eta_}}, -1, 1).slope.lo;
  if (!(frame.leastSlope_ > 0.0))
    return {};
  frame.density_ = triangle.fraction / area;
  for (std::size_t i = 0; i < 3; ++i) {
    const Position to = combined(x[i], -1.0, frame.centroid_);
    frame.corners_[i] = {dotProduct(to, frame.xi_), dotProduct(to, frame.eta_)};
  }
  return frame;
}

Region::Point SwitchFrame::place(double xi, double eta) const
{
  return combined(combined(centroid_, xi, xi_), eta, eta_);
}

double SwitchFrame::value(const ExpressionTree& s, double xi, double eta) const
{
  double result = 0.0;
  s.values(place(xi, eta).data(), 1, &result);
  return result;
}

/// With t = -1 and 1 at the ends, a function is their linear interpolant less (1 - t^2) times a second Taylor
/// coefficient.
double SwitchFrame::largest(const ExpressionTree& s, double sign, Point from, Point to) const
{
  const Position a = place(from[0], from[1]), b = place(to[0], to[1]);
  const auto at = [&](const Position& x) {
    const Interval value = enclose(s, {{x}, {{}}}, -1, 1).range;
    return sign > 0.0 ? value.hi : -value.lo;
  };
  const Enclosure between = enclose(s, {{a, b}, {scaled(combined(b, -1.0, a), 0.5)}}, -1, 2);
  const bool isMonotone = between.slope.lo >= 0.0 || between.slope.hi <= 0.0;
  const double rise = sign > 0.0 ? -between.bend.lo : between.bend.hi;
  return std::max(at(a), at(b)) + (isMonotone ? 0.0 : std::max(0.0, rise));
}

Curve SwitchFrame::curve(double middle, double half, const std::vector<double>& eta) const
{
  Curve curve;
  for (std::size_t axis = 0; axis < curve.size(); ++axis) {
    curve[axis].assign(eta.size(), 0.0);
    for (std::size_t k = 0; k < eta.size(); ++k)
      curve[axis][k] = eta_[axis] * eta[k];
    curve[axis][0] += centroid_[axis] + middle * xi_[axis];
    curve[axis][1] += half * xi_[axis];
  }
  return curve;
}

void SwitchFrame::barycentric(const SimplexGeometry& simplex, const Samples::Piece& triangle,
                              std::array<double, 3>& origin, std::array<double, 3>& alongXi,
                              std::array<double, 3>& alongEta) const
{
  const double third = 1.0 / 3.0, middle[3] = {third, third, third};
  simplex.locate(triangle, middle, origin.data());
  const Point p{corners_[1][0] - corners_[0][0], corners_[1][1] - corners_[0][1]};
  const Point q{corners_[2][0] - corners_[0][0], corners_[2][1] - corners_[0][1]};
  const double determinant = p[0] * q[1] - p[1] * q[0];
  // Local coordinates of corners 1 and 2 per xi and eta.
  const double ofXi[2] = {q[1] / determinant, -p[1] / determinant};
  const double ofEta[2] = {-q[0] / determinant, p[0] / determinant};
  const auto at = [&](std::size_t corner, std::size_t k) { return triangle.corners[corner * 3 + k]; };
  for (std::size_t k = 0; k < 3; ++k) {
    alongXi[k] = ofXi[0] * (at(1, k) - at(0, k)) + ofXi[1] * (at(2, k) - at(0, k));
    alongEta[k] = ofEta[0] * (at(1, k) - at(0, k)) + ofEta[1] * (at(2, k) - at(0, k));
  }
}

} // namespace ndframe

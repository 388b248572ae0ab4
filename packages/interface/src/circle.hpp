#pragma once

#include <optional>
#include <string>

#include "ndframe/interface/side_map.hpp"

namespace ndframe
{

/// How far from the axis, or the centre, a surface still faces a flat side, relative to its radius.
double reachOf(double radius);

/// p - x along a direction, as an expression.
std::string along(const Direction& direction, const Direction& p, int dim);

/// to + sign (R - sqrt(R^2 - s)) as an expression that does not cancel, however large R is; `to`: the distance of the
/// plane that touches at s = 0, s >= 0: the square of the distance from there. Where s is above `most` it goes on flat.
std::string distance(const std::string& to, double radius, double sign, const std::string& s,
                     std::optional<double> most = std::nullopt);

/// A circle in the plane, full or hollow. On a straight side the distance along n is known everywhere and no polygon
/// comes in; a curved side sees an arc between the points that its vertices face.
class Circle
{
public:
  Circle(const Direction& centre, double radius, double sign) : centre_(centre), radius_(radius), sign_(sign) {}

  /// Where the ray from x along the unit vector n meets it; none where it is too oblique to face it.
  std::optional<Direction> hit(const Direction& x, const Direction& n) const;
  std::optional<SideEdge> arcFacing(const SideEdge& edge) const;
  /// The part of a straight edge that it faces, seen from the other side.
  std::optional<SideEdge> lineFacing(const SideEdge& edge) const;
  /// Along the outward normal of a straight edge.
  std::string distanceFrom(const SideEdge& edge) const;

private:
  /// The point where it looks against n.
  Direction nearest(const Direction& n) const;
  bool isAhead(const Direction& x, const Direction& n) const;
  /// R - sqrt(R^2 - s^2)
  double riseAt(double s) const;

  Direction centre_;
  double radius_, sign_;
};

} // namespace ndframe

#include "circle.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "obstacle_list.hpp"
#include "rays.hpp"

namespace ndframe
{

double reachOf(double radius)
{
  return std::sqrt(1.0 - facingCosine * facingCosine) * radius;
}

std::string along(const Direction& direction, const Direction& p, int dim)
{
  std::string sum;
  for (std::size_t k = 0; k < std::size_t(dim); ++k)
    sum += fmt::format("{}{:.17g}*({:.17g}-{})", k > 0 ? "+" : "", direction[k], p[k], "xyz"[k]);
  return "(" + sum + ")";
}

std::string distance(const std::string& to, double radius, double sign, const std::string& s,
                     std::optional<double> most)
{
  const double square = radius * radius;
  const std::string left = fmt::format("{:.17g}-({})", square, s);
  return fmt::format("{}{}{}/({:.17g}+sqrt({}))", to, sign > 0.0 ? "+" : "-",
                     most ? fmt::format("min({:.17g},{})", *most, s) : fmt::format("({})", s), radius,
                     most ? fmt::format("max({:.17g},{})", square - *most, left) : left);
}

std::optional<Direction> Circle::hit(const Direction& x, const Direction& n) const
{
  const Direction to = difference(nearest(n), x);
  const double across = cross(to, n);
  if (std::abs(across) > reachOf(radius_) || !isAhead(x, n))
    return std::nullopt;
  return plus(x, dotProduct(to, n) + sign_ * riseAt(across), n);
}

std::optional<SideEdge> Circle::arcFacing(const SideEdge& edge) const
{
  const auto first = hit(edge.ends[0], unit(edge.normals[0])), last = hit(edge.ends[1], unit(edge.normals[1]));
  if (!first || !last)
    return std::nullopt;
  SideEdge arc = edgeBetween(*last, *first);
  arc.bulge = plus({}, riseAt(arc.length() / 2.0), unit(difference(arc.at(0.5), centre_)));
  return arc;
}

std::optional<SideEdge> Circle::lineFacing(const SideEdge& edge) const
{
  const Direction along = unit(difference(edge.ends[1], edge.ends[0])), n = edge.normals[0];
  const double centre = dotProduct(difference(centre_, edge.ends[0]), along), reach = reachOf(radius_);
  const double low = std::max(0.0, centre - reach), high = std::min(edge.length(), centre + reach);
  if (low >= high || !isAhead(edge.ends[0], n))
    return std::nullopt;
  return edgeBetween(plus(edge.ends[0], high, along), plus(edge.ends[0], low, along));
}

std::string Circle::distanceFrom(const SideEdge& edge) const
{
  const Direction n = edge.normals[0], p = nearest(n);
  return distance(along(n, p, 2), radius_, sign_, fmt::format("{}^2", along({-n[1], n[0]}, p, 2)));
}

Direction Circle::nearest(const Direction& n) const
{
  return plus(centre_, -sign_ * radius_, n);
}

bool Circle::isAhead(const Direction& x, const Direction& n) const
{
  return sign_ < 0.0 || dotProduct(difference(centre_, x), n) > 0.0;
}

double Circle::riseAt(double s) const
{
  return s * s / (radius_ + std::sqrt(radius_ * radius_ - s * s));
}

} // namespace ndframe

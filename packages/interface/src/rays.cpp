#include "rays.hpp"

#include <cmath>

namespace ndframe
{

Direction difference(const Direction& a, const Direction& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double cross(const Direction& a, const Direction& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

Direction normalAt(const SideEdge& edge, double s)
{
  return {(1.0 - s) * edge.normals[0][0] + s * edge.normals[1][0],
          (1.0 - s) * edge.normals[0][1] + s * edge.normals[1][1], 0.0};
}

Direction ownNormal(const SideEdge& edge)
{
  const Direction along = difference(edge.ends[1], edge.ends[0]);
  const double length = edge.length();
  return {along[1] / length, -along[0] / length, 0.0};
}

std::optional<double> rayThrough(const SideEdge& edge, const Direction& y)
{
  const Direction to = difference(y, edge.ends[0]), along = difference(edge.ends[1], edge.ends[0]);
  const Direction turning = difference(edge.normals[1], edge.normals[0]);
  const double c = cross(to, edge.normals[0]), a = -cross(along, turning);
  const double b = cross(to, turning) - cross(along, edge.normals[0]);
  if (c * (a + b + c) >= 0.0)
    return std::nullopt;
  const double root = std::sqrt(std::max(0.0, b * b - 4.0 * a * c)), q = -0.5 * (b + std::copysign(root, b));
  const double s = std::abs(q) > 0.0 ? c / q : 0.0;
  return s >= 0.0 && s <= 1.0 ? s : q / a;
}

std::optional<Hit> meet(const Direction& x, const Direction& n, const SideEdge& edge)
{
  const Direction along = difference(edge.ends[1], edge.ends[0]);
  const double across = cross(along, n);
  if (across == 0.0)
    return std::nullopt;
  const double place = cross(difference(x, edge.ends[0]), n) / across;
  return Hit{place, dotProduct(difference(edge.at(place), x), n) / std::sqrt(dotProduct(n, n))};
}

} // namespace ndframe

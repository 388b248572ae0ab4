#pragma once

#include <cmath>

#include "side_topology.hpp"

namespace ndframe
{

using Flat = std::array<double, 2>;

inline Vector3 minus(const Vector3& a, const Vector3& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline Vector3 crossProduct(const Vector3& a, const Vector3& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline double norm(const Vector3& a)
{
  return std::sqrt(innerProduct(a, a));
}

/// Positive where the corners go round counterclockwise.
inline double areaOf(const Flat& a, const Flat& b, const Flat& c)
{
  return 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
}

/// Coordinates in the plane of a facet.
class Plane
{
public:
  Plane(const SideTopology& side, int facet);

  Flat operator()(const Vector3& x) const
  {
    const Vector3 from = minus(x, origin_);
    return {innerProduct(from, axes_[0]), innerProduct(from, axes_[1])};
  }
  /// Of a direction.
  Flat along(const Vector3& way) const { return {innerProduct(way, axes_[0]), innerProduct(way, axes_[1])}; }
  /// A point that was moved within the plane from where it had these coordinates.
  Vector3 moved(const Vector3& x, const Flat& from, const Flat& to) const
  {
    Vector3 result = x;
    for (std::size_t k = 0; k < 3; ++k)
      result[k] += (to[0] - from[0]) * axes_[0][k] + (to[1] - from[1]) * axes_[1][k];
    return result;
  }

private:
  Vector3 origin_;
  std::array<Vector3, 2> axes_{};
};

/// Facets that are near each other and in one plane (samePlane), their bodies on different sides of it.
std::vector<std::array<int, 2>> flatPairs(const SideTopology& first, const SideTopology& second);

/// Two facets of solids that lie on each other in a part of positive area.
struct OverlappingFacets
{
  int first, second; ///< places in the two lists of facets
  double area;       ///< of the part
};

std::vector<OverlappingFacets> overlappingFacets(const SideTopology& first, const SideTopology& second);

} // namespace ndframe

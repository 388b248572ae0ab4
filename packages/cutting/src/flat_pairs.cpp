#include "flat_pairs.hpp"

#include <algorithm>

namespace ndframe
{
namespace
{

/// Facets are in one plane up to round-off: this part of the smaller one's size (the root of its area), and this one of
/// the coordinates.
constexpr double samePlane = 1e-10, ofCoordinates = 1e-14;
/// Boxes of facets are compared with this leeway.
constexpr double near = 1e-6;
/// Facets overlap in more than this part of the smaller one.
constexpr double overlapping = 1e-7;

/// Facets in one plane, their bodies on different sides of it.
bool lieInOnePlane(const SideTopology& first, int f, const SideTopology& second, int g)
{
  if (innerProduct(first.normal(f), second.normal(g)) > 0.0)
    return false;
  double largest = 0.0;
  for (const int vertex : first.vertices(f))
    for (const double x : first.point(vertex))
      largest = std::max(largest, std::abs(x));
  const double tolerance = samePlane * std::min(first.sizeOfFacet(f), second.sizeOfFacet(g)) + ofCoordinates * largest;
  const auto isIn = [tolerance](const SideTopology& plane, int facet, const SideTopology& other, int otherFacet) {
    const Vector3 origin = plane.point(plane.vertices(facet)[0]);
    const auto& v = other.vertices(otherFacet);
    return std::all_of(v.begin(), v.end(), [&](int vertex) {
      return std::abs(innerProduct(plane.normal(facet), minus(other.point(vertex), origin))) <= tolerance;
    });
  };
  return isIn(first, f, second, g) || isIn(second, g, first, f);
}

/// The part of a convex polygon to the left of a line.
std::vector<Flat> clipped(const std::vector<Flat>& polygon, const Flat& a, const Flat& b)
{
  std::vector<Flat> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Flat &x = polygon[i], &y = polygon[(i + 1) % polygon.size()];
    const double here = areaOf(a, b, x), there = areaOf(a, b, y);
    if (here >= 0.0)
      result.push_back(x);
    if ((here > 0.0 && there < 0.0) || (here < 0.0 && there > 0.0)) {
      const double t = here / (here - there);
      result.push_back({x[0] + t * (y[0] - x[0]), x[1] + t * (y[1] - x[1])});
    }
  }
  return result;
}

double commonArea(const SideTopology& first, int f, const SideTopology& second, int g)
{
  const Plane plane(first, f);
  const auto corners = [&](const SideTopology& side, int facet) {
    std::vector<Flat> points;
    for (const int vertex : side.vertices(facet))
      points.push_back(plane(side.point(vertex)));
    if (areaOf(points[0], points[1], points[2]) < 0.0)
      std::swap(points[0], points[1]);
    return points;
  };
  const auto ours = corners(first, f);
  std::vector<Flat> common = corners(second, g);
  for (std::size_t k = 0; k < 3; ++k)
    common = clipped(common, ours[k], ours[(k + 1) % 3]);
  double area = 0.0;
  for (std::size_t i = 1; i + 1 < common.size(); ++i)
    area += areaOf(common[0], common[i], common[i + 1]);
  return area;
}

} // namespace

Plane::Plane(const SideTopology& side, int facet) : origin_(side.point(side.vertices(facet)[0]))
{
  const Vector3 along = minus(side.point(side.vertices(facet)[1]), origin_);
  const double length = norm(along);
  for (std::size_t k = 0; k < 3; ++k)
    axes_[0][k] = along[k] / length;
  axes_[1] = crossProduct(side.normal(facet), axes_[0]);
}

std::vector<std::array<int, 2>> flatPairs(const SideTopology& first, const SideTopology& second)
{
  std::vector<std::array<int, 2>> pairs = nearFacets(first, second, near);
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(),
                             [&](const auto& pair) { return !lieInOnePlane(first, pair[0], second, pair[1]); }),
              pairs.end());
  return pairs;
}

std::vector<OverlappingFacets> overlappingFacets(const SideTopology& first, const SideTopology& second)
{
  std::vector<OverlappingFacets> result;
  for (const auto& [f, g] : flatPairs(first, second)) {
    const double smaller = std::min(first.sizeOfFacet(f), second.sizeOfFacet(g)),
                 area = commonArea(first, f, second, g);
    if (area > overlapping * smaller * smaller)
      result.push_back({f, g, area});
  }
  return result;
}

} // namespace ndframe

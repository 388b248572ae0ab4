#include "drawn_travel.hpp"

#include <algorithm>
#include <cmath>

namespace ndframe
{

namespace
{

constexpr double steepest = 0.1; ///< facets nearly along the direction meet nothing by it
constexpr double overlap = 0.01; ///< of the scene: what chords of curves may overlap by at the start

using Point = std::array<double, 2>;

struct Segment
{
  Point from, to;
};

/// The facets of a side whose normal has a part along a direction.
std::vector<Segment> facing(const DrawnBody& body, const std::string& side, const Vector3& direction)
{
  std::vector<Segment> segments;
  for (const Facet& facet : body.mesh.findSide(side)->facets) {
    Vector3 normal{};
    facetNormal(body.mesh, facet, normal.data());
    if (dot(normal, direction) < steepest)
      continue;
    std::array<int, 3> vertices{};
    facetVertices(body.mesh, facet, vertices.data());
    const double *const a = body.mesh.point(vertices[0]), *const b = body.mesh.point(vertices[1]);
    segments.push_back({{a[0], a[1]}, {b[0], b[1]}});
  }
  return segments;
}

/// t with p + t d on a segment.
std::optional<double> meets(const Point& p, const Vector3& d, const Segment& segment)
{
  const double x = segment.to[0] - segment.from[0], y = segment.to[1] - segment.from[1];
  const double u = segment.from[0] - p[0], v = segment.from[1] - p[1];
  const double area = d[0] * y - d[1] * x;
  const double at = (d[1] * u - d[0] * v) / area; // along the segment
  if (!(at >= 0.0 && at <= 1.0))
    return std::nullopt;
  return (u * y - v * x) / area;
}

/// The least way of the ends of some segments to others, above a lower limit.
double leastWay(const std::vector<Segment>& from, const Vector3& direction, const std::vector<Segment>& to,
                double lower, double least)
{
  for (const Segment& start : from)
    for (const Point& p : {start.from, start.to})
      for (const Segment& target : to)
        if (const auto way = meets(p, direction, target); way && *way > lower)
          least = std::min(least, *way);
  return least;
}

Vector3 opposite(const Vector3& v)
{
  return {-v[0], -v[1], -v[2]};
}

} // namespace

std::optional<double> travelUntilContact(const DrawnAssembly& scene, const DrawnContact& contact, std::size_t moved,
                                         const Vector3& direction)
{
  if (scene.dim != 2)
    return std::nullopt;
  const bool isFirst = contact.first == moved;
  const auto ours = facing(scene.bodies[moved], isFirst ? contact.firstSide : contact.secondSide, direction);
  const auto theirs = facing(scene.bodies[isFirst ? contact.second : contact.first],
                             isFirst ? contact.secondSide : contact.firstSide, opposite(direction));
  const double never = 2.0 * scene.extent, lower = -overlap * scene.extent;
  const double least =
      leastWay(theirs, opposite(direction), ours, lower, leastWay(ours, direction, theirs, lower, never));
  return least < never ? std::optional<double>(std::max(0.0, least)) : std::nullopt;
}

} // namespace ndframe

#include <algorithm>
#include <cmath>
#include <map>

#include "ndframe/interface/obstacle.hpp"

namespace ndframe
{
namespace
{

/// The strip's thickness, relative to the size of what faces it.
constexpr double thickness = 0.04;
/// Places on an edge nearer than this are one.
constexpr double samePlace = 1e-9;
/// A vertex of the body that is so near to the end of the rigid body, relative to its facet, is moved there (insertion)
/// and gives no vertex of its own.
constexpr double nearEnd = 0.05;

/// A facet of the body along an edge of its polygon.
struct Placed
{
  double low, high;
};

/// From where to where a stretch of the second side's edge is covered, and the vertices between.
struct Covered
{
  double low, high;
  std::vector<double> places;
};

std::vector<std::vector<Placed>> placed(const SidePolygon& polygon, const Mesh& mesh, const std::vector<Facet>& facets)
{
  std::vector<std::vector<Placed>> ofEdges(polygon.edges().size());
  for (const Facet facet : facets)
    if (const Stretch on = polygon.locate(mesh, facet); on.edge >= 0)
      ofEdges[std::size_t(on.edge)].push_back({std::min(on.from, on.to), std::max(on.from, on.to)});
  return ofEdges;
}

Covered coveredBy(const SideSegment& segment, const std::vector<Placed>& facets, bool isSameLine)
{
  const double first = segment.first[0], last = segment.first[1];
  const auto onSecond = [&](double place) {
    const double t = (place - first) / (last - first);
    return (1.0 - t) * segment.second[0] + t * segment.second[1];
  };
  Covered covered{std::min(segment.second[0], segment.second[1]), std::max(segment.second[0], segment.second[1]), {}};
  std::vector<double> inside, tooNear;
  for (const Placed& facet : facets)
    for (const double place : {facet.low, facet.high}) {
      const double toEnd = std::min(place - first, last - place);
      const double least = isSameLine ? nearEnd * (facet.high - facet.low) : samePlace;
      (toEnd > least ? inside : tooNear).push_back(place);
    }
  for (const double place : inside)
    if (std::none_of(tooNear.begin(), tooNear.end(), [&](double other) { return std::abs(place - other) < samePlace; }))
      covered.places.push_back(onSecond(place));
  covered.places.insert(covered.places.end(), {covered.low, covered.high});
  return covered;
}

/// The strip of one map: vertices by edge and place, those at which edges meet once.
class Strip
{
public:
  Strip(Mesh& mesh, const std::vector<SideEdge>& edges, double depth) : mesh_(mesh), edges_(edges), depth_(depth) {}

  /// Two triangles behind the stretch from `low` to `high`.
  Facet add(std::size_t edge, double low, double high)
  {
    const auto [a, behindA] = pair(edge, low);
    const auto [b, behindB] = pair(edge, high);
    mesh_.cells.insert(mesh_.cells.end(), {a, b, behindB, a, behindB, behindA});
    return {mesh_.numCells() - 2, 2};
  }

private:
  /// The vertex there and the one behind it.
  std::pair<int, int> pair(std::size_t edge, double place)
  {
    const Direction x = edges_[edge].at(place);
    const std::pair<double, double> key{std::round(x[0] / (samePlace * depth_)),
                                        std::round(x[1] / (samePlace * depth_))};
    const auto [found, isNew] = vertices_.insert({key, mesh_.numPoints()});
    if (isNew) {
      const Direction inward = inwardAt(edge, place);
      for (const double by : {0.0, depth_})
        mesh_.points.insert(mesh_.points.end(), {x[0] + by * inward[0], x[1] + by * inward[1]});
    }
    return {found->second, found->second + 1};
  }

  /// Where edges meet the mean of both.
  Direction inwardAt(std::size_t edge, double place) const
  {
    const Direction x = edges_[edge].at(place);
    Direction sum{};
    for (const SideEdge& other : edges_)
      for (const Direction& end : other.ends)
        if (&other == &edges_[edge] || std::hypot(end[0] - x[0], end[1] - x[1]) < samePlace * depth_)
          for (std::size_t k = 0; k < 2; ++k)
            sum[k] -= other.normals[0][k];
    const double length = std::hypot(sum[0], sum[1]);
    return {sum[0] / length, sum[1] / length, 0.0};
  }

  Mesh& mesh_;
  const std::vector<SideEdge>& edges_;
  double depth_;
  std::map<std::pair<double, double>, int> vertices_;
};

double sizeOf(const SideMap& map)
{
  std::array<double, 2> low{HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL};
  for (const SideSegment& segment : map.segments())
    for (const double t : {0.0, 1.0})
      for (std::size_t k = 0; k < 2; ++k) {
        const double x = map.pointOnSecond(segment, t)[k];
        low[k] = std::min(low[k], x);
        high[k] = std::max(high[k], x);
      }
  return std::hypot(high[0] - low[0], high[1] - low[1]);
}

} // namespace

void addStrip(Mesh& mesh, const std::string& name, const SideMap& map, const Mesh& first,
              const std::vector<Facet>& facets)
{
  const auto ofEdges = placed(map.first(), first, facets);
  std::map<int, std::vector<Covered>> covered;
  for (const SideSegment& segment : map.segments())
    covered[segment.secondEdge].push_back(
        coveredBy(segment, ofEdges[std::size_t(segment.firstEdge)], map.isSameLine(segment)));
  mesh.dim = 2;
  Strip strip(mesh, map.second().edges(), thickness * sizeOf(map));
  Side side{name, {}};
  for (auto& [edge, stretches] : covered) {
    std::vector<double> places;
    for (const Covered& stretch : stretches)
      places.insert(places.end(), stretch.places.begin(), stretch.places.end());
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end(), [](double a, double b) { return b - a < samePlace; }),
                 places.end());
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      const double middle = 0.5 * (places[i] + places[i + 1]);
      if (std::any_of(stretches.begin(), stretches.end(),
                      [&](const Covered& s) { return s.low < middle && middle < s.high; }))
        side.facets.push_back(strip.add(std::size_t(edge), places[i], places[i + 1]));
    }
  }
  mesh.sides.push_back(std::move(side));
}

} // namespace ndframe

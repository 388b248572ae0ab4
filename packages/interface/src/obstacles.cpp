#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "ndframe/base/expression.hpp"
#include "obstacle_list.hpp"
#include "rays.hpp"

namespace ndframe
{
namespace
{

/// A half-space, or in the plane the part behind a stretch of its boundary.
class Plane final : public Obstacle
{
public:
  explicit Plane(const Params& list) : list_(list) {}

  ObstacleOutline facing(const SidePolygon& side) const override
  {
    list_.checkDisplacement(2);
    const Direction point = list_.vector("Point", 2), normal = outward(2), along{normal[1], -normal[0], 0.0};
    double low = std::numeric_limits<double>::max(), high = -low, far = 0.0;
    for (const SideEdge& edge : side.edges())
      for (const Direction& end : edge.ends) {
        const Direction apart = difference(end, point);
        low = std::min(low, dotProduct(apart, along));
        high = std::max(high, dotProduct(apart, along));
        far = std::max(far, std::abs(dotProduct(apart, normal)));
      }
    const double reach = 2.0 * far + (high - low); // rays lean by 60 degrees at most
    const auto extent = extentOf();
    low = std::max(low - reach, extent[0]);
    high = std::min(high + reach, extent[1]);
    if (low >= high)
      return {SidePolygon(std::vector<SideEdge>()), {}};
    return {SidePolygon({edgeBetween(plus(point, high, along), plus(point, low, along))}), {}};
  }

  /// Contact is asked along the plane's normal: a point of the side is not in the body if its distance from the plane
  /// is not negative, however the side bends.
  ObstacleSurface facing(const Mesh& mesh, const std::vector<Facet>& facets) const override
  {
    list_.checkDisplacement(3);
    const Direction point = list_.vector("Point", 3), normal = outward(3);
    if (list_.list().isGiven("Extent"))
      throw InputError(list_.mistake(
          "Extent", "Extent counts along a line; a plane that solids touch is unbounded: cut their sides."));
    constexpr double roundOff = 1e-9; // a facet at 60 degrees faces it on every mesh
    ObstacleSurface surface{{}, plus({}, -1.0, normal), {}};
    for (const Facet facet : facets) {
      Direction own{};
      facetNormal(mesh, facet, own.data());
      if (dotProduct(own, normal) < roundOff - facingCosine)
        surface.facets.push_back(facet);
    }
    const char* names[] = {"x", "y", "z"};
    for (std::size_t k = 0; k < 3; ++k)
      if (normal[k] != 0.0)
        surface.gap +=
            fmt::format("{}({:.17g})*({}-({:.17g}))", surface.gap.empty() ? "" : "+", normal[k], names[k], point[k]);
    return surface;
  }

private:
  Direction outward(int dim) const
  {
    return list_.direction("Normal", dim, "points out of the rigid body, towards what touches it");
  }

  std::array<double, 2> extentOf() const
  {
    const auto extent = list_.list().get<std::vector<double>>("Extent");
    if (extent.empty())
      return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    if (extent.size() != 2 || extent[0] >= extent[1])
      throw InputError(list_.mistake("Extent", "Extent takes two numbers, the smaller one first."));
    return {extent[0], extent[1]};
  }

  ObstacleList list_;
};

/// What lies at a given distance from the side.
class AtDistance final : public Obstacle
{
public:
  explicit AtDistance(const Params& list) : list_(list), distance_(list.expression("Distance").text()) {}

  ObstacleOutline facing(const SidePolygon& side) const override
  {
    list_.checkDisplacement(2);
    std::vector<SideEdge> edges;
    for (const SideEdge& edge : side.edges()) {
      edges.push_back(edgeBetween(edge.ends[1], edge.ends[0]));
      edges.back().bulge = edge.bulge;
    }
    return {SidePolygon(std::move(edges)), distance_};
  }

  ObstacleSurface facing(const Mesh&, const std::vector<Facet>& facets) const override
  {
    list_.checkDisplacement(3);
    return {facets, std::nullopt, distance_};
  }

private:
  ObstacleList list_;
  std::string distance_;
};

template <class Component>
auto build()
{
  return [](const Params& list) { return std::make_unique<Component>(list); };
}

} // namespace

Direction plus(const Direction& a, double factor, const Direction& b)
{
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

Direction unit(const Direction& v)
{
  const double length = std::sqrt(dotProduct(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}

SideEdge edgeBetween(const Direction& from, const Direction& to)
{
  SideEdge edge{{from, to}, {}};
  edge.normals = {ownNormal(edge), ownNormal(edge)};
  return edge;
}

Direction ObstacleList::vector(const char* key, int dim) const
{
  const auto given = list_.get<std::vector<double>>(key);
  if (int(given.size()) != dim)
    throw InputError(mistake(key, fmt::format("{} has {} coordinates, and what touches the body is {}-D: give {}.", key,
                                              given.size(), dim, dim == 2 ? "two" : "three")));
  return {given[0], given[1], dim == 3 ? given[2] : 0.0};
}

Direction ObstacleList::direction(const char* key, int dim, const char* meaning) const
{
  const Direction given = vector(key, dim);
  if (dotProduct(given, given) == 0.0)
    throw InputError(mistake(key, fmt::format("{} is zero; it {}.", key, meaning)));
  return unit(given);
}

void ObstacleList::checkDisplacement(int dim) const
{
  if (!list_.get<std::vector<double>>("Displacement").empty())
    vector("Displacement", dim);
}

std::vector<ParamSpec> withDisplacement(std::vector<ParamSpec> params)
{
  params.push_back({"Displacement", std::vector<double>{},
                    "How far it is moved from there, a length in x and y, for solids also in z: presses it against the "
                    "bodies that touch it. Empty: it stays there."});
  return params;
}

void registerObstacles(Registry<Obstacle>& registry)
{
  registry.add(
      "Plane",
      "A straight boundary; for solids a plane. Solids touch it along its own normal, also where their sides "
      "are curved.",
      withDisplacement(
          {ParamSpec::required("Point", Kind::Doubles, "A point on it: lengths x and y, for solids also z."),
           ParamSpec::required("Normal", Kind::Doubles, "Points out of the rigid body; of any nonzero length."),
           {"Extent", std::vector<double>{},
            "In 2D: where it begins and ends, lengths measured from Point along the normal rotated clockwise (for {0, "
            "1}: "
            "along x). Empty: unbounded. Two planes leave a hole between them."}}),
      build<Plane>());
  registerRoundObstacles(registry);
  registry.add("Expression", "Any shape, given by its distance.",
               withDisplacement(
                   {ParamSpec::required("Distance", Kind::Expression,
                                        "From the side's points along their outward normal to the rigid body, >= 0, "
                                        "a length.")}),
               build<AtDistance>());
}

} // namespace ndframe

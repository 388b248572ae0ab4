#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "circle.hpp"
#include "obstacle_list.hpp"
#include "rays.hpp"

namespace ndframe
{
namespace
{

double signOf(const Params& list)
{
  return list.get<bool>("Hollow") ? -1.0 : 1.0;
}

Direction crossProduct(const Direction& a, const Direction& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Some unit vector across n.
Direction across(const Direction& n)
{
  const Direction size{std::abs(n[0]), std::abs(n[1]), std::abs(n[2])};
  Direction axis{};
  axis[std::size_t(std::min_element(size.begin(), size.end()) - size.begin())] = 1.0;
  return unit(crossProduct(n, axis));
}

/// The outward normal of a flat side; none if it bends.
std::optional<Direction> flatNormal(const Mesh& mesh, const std::vector<Facet>& facets)
{
  constexpr double same = 1e-9;
  Direction first{}, own{};
  facetNormal(mesh, facets.front(), first.data());
  for (const Facet facet : facets) {
    facetNormal(mesh, facet, own.data());
    const Direction turned = crossProduct(first, own);
    if (dotProduct(first, own) < 0.0 || std::sqrt(dotProduct(turned, turned)) > same)
      return std::nullopt;
  }
  return first;
}

/// A sphere, or a cylinder with its axis, as a flat side with outward normal n sees it. With P the projection across
/// the axis (a sphere's: all), q = |P n|^2 and unit vectors t across n and the axis, its distance along n is
///
///   (P n . (p - x)) / q + s / (R + sqrt(R^2 - s)) / sqrt(q),  p = c - R P n / sqrt(q),  s = sum (t . (p - x))^2,
///
/// which is (P n . (c - x)) / q - sqrt((R^2 - s) / q) without its cancellation; minus and plus exchanged for a hollow
/// one. Where the surface turns away by more than 60 degrees it goes on flat, so that all of the side has a gap.
class RoundSurface
{
public:
  RoundSurface(const Direction& centre, double radius, double sign, const std::optional<Direction>& axis,
               const Direction& n)
      : centre_(centre), radius_(radius), sign_(sign), ahead_(axis ? plus(n, -dotProduct(n, *axis), *axis) : n)
  {
    if (axis)
      across_ = {unit(crossProduct(*axis, ahead_))};
    else
      across_ = {across(n), crossProduct(n, across(n))};
  }

  /// Whether the side looks at it, not along its axis or away from it.
  static bool canFace(const Direction& n, const std::optional<Direction>& axis)
  {
    return !axis || std::abs(dotProduct(n, *axis)) <= facingCosine;
  }

  bool faces(const double* x) const
  {
    return sign_ < 0.0 || dotProduct(difference(centre_, {x[0], x[1], x[2]}), ahead_) > 0.0;
  }

  /// All lengths times sqrt(q) on the way.
  std::string gapOf(const Mesh& mesh, const std::vector<Facet>& facets) const
  {
    const double q = dotProduct(ahead_, ahead_), reach = reachOf(radius_) * reachOf(radius_);
    const Direction forward = unit(ahead_), p = plus(centre_, -sign_ * radius_, forward);
    std::string s;
    for (const Direction& t : across_)
      s += (s.empty() ? "" : "+") + fmt::format("{}^2", along(t, p, 3));
    const bool reachesBeyond = largestSquare(mesh, facets, p) > reach;
    return fmt::format(
        "({})/{:.17g}",
        distance(along(forward, p, 3), radius_, sign_, s, reachesBeyond ? std::optional(reach) : std::nullopt),
        std::sqrt(q));
  }

private:
  /// Of the squares of the distances across: convex, so at a vertex.
  double largestSquare(const Mesh& mesh, const std::vector<Facet>& facets, const Direction& p) const
  {
    double largest = 0.0;
    for (const Facet facet : facets) {
      int vertices[3];
      facetVertices(mesh, facet, vertices);
      for (const int vertex : vertices) {
        const double* x = mesh.point(vertex);
        double square = 0.0;
        for (const Direction& t : across_) {
          const double at = dotProduct(difference(p, {x[0], x[1], x[2]}), t);
          square += at * at;
        }
        largest = std::max(largest, square);
      }
    }
    return largest;
  }

  Direction centre_;
  double radius_, sign_;
  Direction ahead_; ///< P n
  std::vector<Direction> across_;
};

/// The surface that a side of a solid sees; axis: none of a sphere.
ObstacleSurface roundFacing(const ObstacleList& list, const std::optional<Direction>& axis, const Mesh& mesh,
                            const std::vector<Facet>& facets)
{
  list.checkDisplacement(3);
  const auto normal = flatNormal(mesh, facets);
  if (!normal)
    throw InputError(
        list.mistake("", "faces a bent side; in 3D a side that meets a round rigid body must be flat: cut the side so "
                         "that each interface has one plane, or give the distance as an Expression."));
  if (!RoundSurface::canFace(*normal, axis))
    return {};
  const RoundSurface surface(list.vector("Centre", 3), list.list().get<double>("Radius"), signOf(list.list()), axis,
                             *normal);
  int vertices[3];
  facetVertices(mesh, facets.front(), vertices);
  if (!surface.faces(mesh.point(vertices[0])))
    return {};
  return {facets, std::nullopt, surface.gapOf(mesh, facets)};
}

class Cylinder final : public Obstacle
{
public:
  explicit Cylinder(const Params& list) : list_(list) {}

  ObstacleOutline facing(const SidePolygon& side) const override
  {
    list_.checkDisplacement(2);
    if (!list_.list().get<std::vector<double>>("Axis").empty())
      throw InputError(list_.mistake("Axis", "in 2D the axis is z; remove Axis."));
    const Circle circle(list_.vector("Centre", 2), list_.list().get<double>("Radius"), signOf(list_.list()));
    std::vector<SideEdge> straight, curved;
    std::string gap;
    for (const SideEdge& edge : side.edges())
      if (const auto found = edge.turns ? circle.arcFacing(edge) : circle.lineFacing(edge); found) {
        (edge.turns ? curved : straight).push_back(*found);
        if (!edge.turns)
          gap = circle.distanceFrom(edge);
      }
    if (straight.size() > 1 || (!straight.empty() && !curved.empty()))
      throw InputError(list_.mistake("", "faces a side of several straight lines, or of straight and curved ones; cut "
                                         "the side so that each interface has one straight line or one curve."));
    return {SidePolygon(straight.empty() ? curved : straight), gap};
  }

  ObstacleSurface facing(const Mesh& mesh, const std::vector<Facet>& facets) const override
  {
    return roundFacing(list_, list_.direction("Axis", 3, "is the direction of the cylinder's axis"), mesh, facets);
  }

private:
  ObstacleList list_;
};

class Sphere final : public Obstacle
{
public:
  explicit Sphere(const Params& list) : list_(list) {}

  ObstacleOutline facing(const SidePolygon&) const override
  {
    throw InputError(list_.mistake("Type", "in 2D there is no Sphere; use Cylinder, whose section is a circle."));
  }

  ObstacleSurface facing(const Mesh& mesh, const std::vector<Facet>& facets) const override
  {
    return roundFacing(list_, std::nullopt, mesh, facets);
  }

private:
  ObstacleList list_;
};

std::vector<ParamSpec> roundParams(const char* centre)
{
  return {ParamSpec::required("Centre", Kind::Doubles, centre),
          ParamSpec::required("Radius", Kind::Double, above(0.0), "Its radius, a length."),
          {"Hollow", false, "The rigid body is what lies outside: a hole around a pin, a socket around a ball."}};
}

} // namespace

void registerRoundObstacles(Registry<Obstacle>& registry)
{
  std::vector<ParamSpec> cylinder = roundParams("Its centre: lengths x and y; for solids a point on its axis.");
  cylinder.push_back({"Axis", std::vector<double>{}, "For solids: the direction of its axis, of any nonzero length."});
  registry.add("Cylinder",
               "A circle in 2D, an infinite cylinder for solids. A flat side sees its exact distance along the side's "
               "normal; a curved side in 2D sees the arcs between the points that its vertices face, as parabolas. For "
               "solids it continues flat where it turns away by more than 60 degrees.",
               withDisplacement(std::move(cylinder)),
               [](const Params& list) { return std::make_unique<Cylinder>(list); });
  registry.add("Sphere",
               "A sphere that flat sides of solids touch, at its exact distance along the side's normal. It continues "
               "flat where it turns away by more than 60 degrees.",
               withDisplacement(roundParams("Its centre: lengths x, y and z.")),
               [](const Params& list) { return std::make_unique<Sphere>(list); });
}

} // namespace ndframe

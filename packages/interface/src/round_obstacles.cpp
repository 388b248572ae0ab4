#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "obstacle_list.hpp"
#include "rays.hpp"

namespace ndframe
{
namespace
{

/// How far from the axis, or the centre, a surface still faces a flat side, relative to its radius.
double reachOf(double radius)
{
  return std::sqrt(1.0 - facingCosine * facingCosine) * radius;
}

double signOf(const Params& list)
{
  return list.get<bool>("Hollow") ? -1.0 : 1.0;
}

/// p - x along a direction, as an expression.
std::string along(const Direction& direction, const Direction& p, int dim)
{
  std::string sum;
  for (std::size_t k = 0; k < std::size_t(dim); ++k)
    sum += fmt::format("{}{:.17g}*({:.17g}-{})", k > 0 ? "+" : "", direction[k], p[k], "xyz"[k]);
  return "(" + sum + ")";
}

/// to + sign (R - sqrt(R^2 - s)) as an expression that does not cancel, however large R is; `to`: the distance of the
/// plane that touches at s = 0, s >= 0: the square of the distance from there. Where s is above `most` it goes on flat.
std::string distance(const std::string& to, double radius, double sign, const std::string& s,
                     std::optional<double> most = std::nullopt)
{
  const double square = radius * radius;
  const std::string left = fmt::format("{:.17g}-({})", square, s);
  return fmt::format("{}{}{}/({:.17g}+sqrt({}))", to, sign > 0.0 ? "+" : "-",
                     most ? fmt::format("min({:.17g},{})", *most, s) : fmt::format("({})", s), radius,
                     most ? fmt::format("max({:.17g},{})", square - *most, left) : left);
}

/// A circle in the plane, full or hollow. On a straight side the distance along n is known everywhere and no polygon
/// comes in; a curved side sees an arc between the points that its vertices face.
class Circle
{
public:
  Circle(const Direction& centre, double radius, double sign) : centre_(centre), radius_(radius), sign_(sign) {}

  /// Where the ray from x along the unit vector n meets it; none where it is too oblique to face it.
  std::optional<Direction> hit(const Direction& x, const Direction& n) const
  {
    const Direction to = difference(nearest(n), x);
    const double across = cross(to, n);
    if (std::abs(across) > reachOf(radius_) || !isAhead(x, n))
      return std::nullopt;
    return plus(x, dotProduct(to, n) + sign_ * riseAt(across), n);
  }

  std::optional<SideEdge> arcFacing(const SideEdge& edge) const
  {
    const auto first = hit(edge.ends[0], unit(edge.normals[0])), last = hit(edge.ends[1], unit(edge.normals[1]));
    if (!first || !last)
      return std::nullopt;
    SideEdge arc = edgeBetween(*last, *first);
    arc.bulge = plus({}, riseAt(arc.length() / 2.0), unit(difference(arc.at(0.5), centre_)));
    return arc;
  }

  /// The part of a straight edge that it faces, seen from the other side.
  std::optional<SideEdge> lineFacing(const SideEdge& edge) const
  {
    const Direction along = unit(difference(edge.ends[1], edge.ends[0])), n = edge.normals[0];
    const double centre = dotProduct(difference(centre_, edge.ends[0]), along), reach = reachOf(radius_);
    const double low = std::max(0.0, centre - reach), high = std::min(edge.length(), centre + reach);
    if (low >= high || !isAhead(edge.ends[0], n))
      return std::nullopt;
    return edgeBetween(plus(edge.ends[0], high, along), plus(edge.ends[0], low, along));
  }

  /// Along the outward normal of a straight edge.
  std::string distanceFrom(const SideEdge& edge) const
  {
    const Direction n = edge.normals[0], p = nearest(n);
    return distance(along(n, p, 2), radius_, sign_, fmt::format("{}^2", along({-n[1], n[0]}, p, 2)));
  }

private:
  /// The point where it looks against n.
  Direction nearest(const Direction& n) const { return plus(centre_, -sign_ * radius_, n); }
  bool isAhead(const Direction& x, const Direction& n) const
  {
    return sign_ < 0.0 || dotProduct(difference(centre_, x), n) > 0.0;
  }
  /// R - sqrt(R^2 - s^2)
  double riseAt(double s) const { return s * s / (radius_ + std::sqrt(radius_ * radius_ - s * s)); }

  Direction centre_;
  double radius_, sign_;
};

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
        list.mistake("", "faces a side that bends; in space a side that meets a round rigid body must be flat: cut "
                         "the side so that each interface has one plane, or give the distance as an Expression."));
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
      throw InputError(list_.mistake("Axis", "in the plane the axis is that of z; remove Axis."));
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
    throw InputError(
        list_.mistake("Type", "in the plane there is no Sphere; take Cylinder, whose section is a circle."));
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
          ParamSpec::required("Radius", Kind::Double, above(0.0), "Its radius."),
          {"Hollow", false, "The rigid body is what lies outside: a hole around a pin, a socket around a ball."}};
}

} // namespace

void registerRoundObstacles(Registry<Obstacle>& registry)
{
  std::vector<ParamSpec> cylinder = roundParams("Its centre, x and y; for solids a point of its axis.");
  cylinder.push_back({"Axis", std::vector<double>{}, "For solids: the direction of its axis, of any length but zero."});
  registry.add(
      "Cylinder",
      "A circle in the plane, a cylinder without end for solids. A flat side sees its exact distance along the "
      "side's normal; a curved side in the plane sees the arcs between the points that its vertices face, as "
      "parabolas. Solids see it go on flat where it turns away by more than 60 degrees.",
      withDisplacement(std::move(cylinder)), [](const Params& list) { return std::make_unique<Cylinder>(list); });
  registry.add(
      "Sphere",
      "A sphere that flat sides of solids touch, at its exact distance along the side's normal. It goes on flat "
      "where it turns away by more than 60 degrees.",
      withDisplacement(roundParams("Its centre, x, y and z.")),
      [](const Params& list) { return std::make_unique<Sphere>(list); });
}

} // namespace ndframe

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "ndframe/base/expression.hpp"
#include "ndframe/interface/obstacle.hpp"
#include "rays.hpp"

namespace ndframe
{
namespace
{

/// Surfaces face each other up to this cosine between their normals, as edges do (SideMap).
constexpr double facingCosine = 0.5;

Direction plus(const Direction& a, double factor, const Direction& b)
{
  return {a[0] + factor * b[0], a[1] + factor * b[1], 0.0};
}

Direction unit(const Direction& v)
{
  const double length = std::sqrt(dotProduct(v, v));
  return {v[0] / length, v[1] / length, 0.0};
}

/// The body of an edge lies to its left.
SideEdge edgeBetween(const Direction& from, const Direction& to)
{
  SideEdge edge{{from, to}, {}};
  edge.normals = {ownNormal(edge), ownNormal(edge)};
  return edge;
}

/// Two coordinates.
Direction pointOf(const Params& list, const char* key)
{
  const auto given = list.get<std::vector<double>>(key);
  if (given.size() != 2)
    throw InputError(list.mistake(key, fmt::format("{} has {} coordinates; rigid bodies are available in the plane: "
                                                   "give two.",
                                                   key, given.size())));
  return {given[0], given[1], 0.0};
}

/// Those that every rigid body has.
std::vector<ParamSpec> withDisplacement(std::vector<ParamSpec> params)
{
  params.push_back({"Displacement", std::vector<double>{0.0, 0.0},
                    "How far it is moved from there, a length in x and y: presses it on the bodies that touch it."});
  return params;
}

/// Checks the list that all have.
void checkDisplacement(const Params& list)
{
  pointOf(list, "Displacement");
}

/// A half-plane, or the part behind a stretch of its boundary.
class Plane final : public Obstacle
{
public:
  explicit Plane(const Params& list) : point_(pointOf(list, "Point")), normal_(pointOf(list, "Normal"))
  {
    checkDisplacement(list);
    if (dotProduct(normal_, normal_) == 0.0)
      throw InputError(list.mistake("Normal", "is zero; it points out of the rigid body, towards what touches it."));
    normal_ = unit(normal_);
    const auto extent = list.get<std::vector<double>>("Extent");
    if (!extent.empty() && (extent.size() != 2 || extent[0] >= extent[1]))
      throw InputError(list.mistake("Extent", "takes two numbers, the smaller one first."));
    if (!extent.empty())
      extent_ = {extent[0], extent[1]};
  }

  ObstacleOutline facing(const SidePolygon& side) const override
  {
    const Direction along{normal_[1], -normal_[0], 0.0};
    double low = std::numeric_limits<double>::max(), high = -low, far = 0.0;
    for (const SideEdge& edge : side.edges())
      for (const Direction& end : edge.ends) {
        const Direction apart = difference(end, point_);
        low = std::min(low, dotProduct(apart, along));
        high = std::max(high, dotProduct(apart, along));
        far = std::max(far, std::abs(dotProduct(apart, normal_)));
      }
    const double reach = 2.0 * far + (high - low); // rays lean by 60 degrees at most
    low = std::max(low - reach, extent_[0]);
    high = std::min(high + reach, extent_[1]);
    if (low >= high)
      return {SidePolygon(std::vector<SideEdge>()), {}};
    return {SidePolygon({edgeBetween(plus(point_, high, along), plus(point_, low, along))}), {}};
  }

private:
  Direction point_, normal_;
  std::array<double, 2> extent_{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
};

/// A circle, full or hollow. On a straight side the distance along n is known everywhere and no polygon comes in; a
/// curved side sees an arc between the points that its vertices face.
class Cylinder final : public Obstacle
{
public:
  explicit Cylinder(const Params& list)
      : list_(list), centre_(pointOf(list, "Centre")), radius_(list.get<double>("Radius")),
        sign_(list.get<bool>("Hollow") ? -1.0 : 1.0)
  {
    checkDisplacement(list);
  }

  ObstacleOutline facing(const SidePolygon& side) const override
  {
    std::vector<SideEdge> straight, curved;
    std::string gap;
    for (const SideEdge& edge : side.edges())
      if (const auto found = edge.turns ? arcFacing(edge) : lineFacing(edge); found) {
        (edge.turns ? curved : straight).push_back(*found);
        if (!edge.turns)
          gap = distanceFrom(edge);
      }
    if (straight.size() > 1 || (!straight.empty() && !curved.empty()))
      throw InputError(list_.mistake("", "faces a side of several straight lines, or of straight and curved ones; cut "
                                         "the side so that each interface has one straight line or one curve."));
    return {SidePolygon(straight.empty() ? curved : straight), gap};
  }

private:
  /// Where the ray from x along the unit vector n meets it; none where it is too oblique to face it.
  std::optional<Direction> hit(const Direction& x, const Direction& n) const
  {
    const Direction to = difference(centre_, x);
    const double ahead = dotProduct(to, n), across = cross(to, n);
    const double reach = std::sqrt(1.0 - facingCosine * facingCosine) * radius_;
    if (std::abs(across) > reach || (sign_ > 0.0 && ahead <= 0.0))
      return std::nullopt;
    return plus(x, ahead - sign_ * std::sqrt(radius_ * radius_ - across * across), n);
  }

  std::optional<SideEdge> arcFacing(const SideEdge& edge) const
  {
    const auto first = hit(edge.ends[0], unit(edge.normals[0])), last = hit(edge.ends[1], unit(edge.normals[1]));
    if (!first || !last)
      return std::nullopt;
    SideEdge arc = edgeBetween(*last, *first);
    const Direction middle = difference(arc.at(0.5), centre_);
    const double depth = radius_ - std::sqrt(dotProduct(middle, middle));
    arc.bulge = plus({}, depth, unit(middle));
    return arc;
  }

  /// The part of a straight edge that it faces, seen from the other side.
  std::optional<SideEdge> lineFacing(const SideEdge& edge) const
  {
    const Direction along = unit(difference(edge.ends[1], edge.ends[0])), n = edge.normals[0];
    const double centre = dotProduct(difference(centre_, edge.ends[0]), along),
                 reach = std::sqrt(1.0 - facingCosine * facingCosine) * radius_;
    const double low = std::max(0.0, centre - reach), high = std::min(edge.length(), centre + reach);
    if (low >= high || (sign_ > 0.0 && dotProduct(difference(centre_, edge.ends[0]), n) <= 0.0))
      return std::nullopt;
    return edgeBetween(plus(edge.ends[0], high, along), plus(edge.ends[0], low, along));
  }

  /// n . (c - x) - sqrt(R^2 - (t . (c - x))^2), plus for a hollow one.
  std::string distanceFrom(const SideEdge& edge) const
  {
    const Direction n = edge.normals[0];
    const auto part = [this](double x, double y) {
      return fmt::format("({:.17g}*({:.17g}-x)+{:.17g}*({:.17g}-y))", x, centre_[0], y, centre_[1]);
    };
    return fmt::format("{}{}sqrt({:.17g}-{}^2)", part(n[0], n[1]), sign_ > 0.0 ? "-" : "+", radius_ * radius_,
                       part(-n[1], n[0]));
  }

  Params list_;
  Direction centre_;
  double radius_, sign_;
};

/// What lies at a given distance from the side.
class AtDistance final : public Obstacle
{
public:
  explicit AtDistance(const Params& list) : distance_(list.expression("Distance").text()) { checkDisplacement(list); }

  ObstacleOutline facing(const SidePolygon& side) const override
  {
    std::vector<SideEdge> edges;
    for (const SideEdge& edge : side.edges()) {
      edges.push_back(edgeBetween(edge.ends[1], edge.ends[0]));
      edges.back().bulge = edge.bulge;
    }
    return {SidePolygon(std::move(edges)), distance_};
  }

private:
  std::string distance_;
};

template <class Component>
auto build()
{
  return [](const Params& list) { return std::make_unique<Component>(list); };
}

} // namespace

void registerObstacles(Registry<Obstacle>& registry)
{
  registry.add("Plane", "A straight boundary.",
               withDisplacement({ParamSpec::required("Point", Kind::Doubles, "A point of it, x and y."),
                                 ParamSpec::required("Normal", Kind::Doubles,
                                                     "Points out of the rigid body; of any length but zero."),
                                 {"Extent", std::vector<double>{},
                                  "From where to where it goes, counted from Point along the normal turned clockwise "
                                  "(for {0, 1}: along x). Empty: without end. Two planes leave a hole between them."}}),
               build<Plane>());
  registry.add("Cylinder",
               "A circle. A straight side sees its exact distance along the side's normal; a curved one sees the arcs "
               "between the points that the side's vertices face, as parabolas.",
               withDisplacement({ParamSpec::required("Centre", Kind::Doubles, "Its centre, x and y."),
                                 ParamSpec::required("Radius", Kind::Double, above(0.0), "Its radius."),
                                 {"Hollow", false, "The rigid body is what lies outside: a hole around a pin."}}),
               build<Cylinder>());
  registry.add("Expression", "Anything, by its distance.",
               withDisplacement(
                   {ParamSpec::required("Distance", Kind::Expression,
                                        "From the side's points along their outward normal to the rigid body, >= 0, "
                                        "a length.")}),
               build<AtDistance>());
}

} // namespace ndframe

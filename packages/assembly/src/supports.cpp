#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "ndframe/assembly/side_condition.hpp"

namespace ndframe
{
namespace
{

constexpr std::array<Direction, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr std::array<const char*, 3> axisNames{"X", "Y", "Z"};

/// u = 0 on a side, equation (1).
class Clamp final : public Support
{
public:
  using Support::Support;
  std::vector<Direction> directions(const Mesh& mesh) const override { return {axes.begin(), axes.begin() + mesh.dim}; }
};

/// u . n = 0 on a flat side with outward normal n: a symmetry plane or a frictionless guide, inclined or not.
class Roller final : public Support
{
public:
  using Support::Support;

  void check(const Mesh& mesh, Diagnostics& diagnostics) const override
  {
    Support::check(mesh, diagnostics);
    const Side* found = mesh.findSide(params().get<std::string>("Side"));
    if (found == nullptr || found->facets.empty()) // a part of a body may have none of it
      return;
    const auto first = normal(mesh, found->facets.front());
    double bend = 0.0;
    for (const Facet facet : found->facets) {
      const auto n = normal(mesh, facet);
      bend = std::max(bend, std::hypot(n[0] - first[0], n[1] - first[1], n[2] - first[2]));
    }
    if (bend > flatness)
      diagnostics.add(params().mistake(
          "Side",
          fmt::format("a roller needs a straight or flat side; the normal of \"{}\" turns by {:.2g} degrees. Split "
                      "the side into its flat parts.",
                      found->name, 360.0 / M_PI * std::asin(std::min(1.0, 0.5 * bend)))));
  }

  std::vector<Direction> directions(const Mesh& mesh) const override
  {
    const std::vector<Facet>& facets = side(mesh).facets;
    return facets.empty() ? std::vector<Direction>() : std::vector<Direction>{normal(mesh, facets.front())};
  }

private:
  static constexpr double flatness = 1e-5; ///< of the unit normals' difference; mesh files carry some 8 digits

  static Direction normal(const Mesh& mesh, Facet facet)
  {
    Direction n{};
    facetNormal(mesh, facet, n.data());
    return n;
  }
};

/// u . e_k = given value (an expression) for the components that the deck names.
class Displacement : public Support
{
public:
  explicit Displacement(const Params& params) : Support(params)
  {
    for (std::size_t k = 0; k < axes.size(); ++k)
      if (params.has(axisNames[k]))
        axes_.push_back(k), functions_.push_back(sampled(axisNames[k]));
  }

  void check(const Mesh& mesh, Diagnostics& diagnostics) const override
  {
    Support::check(mesh, diagnostics);
    if (axes_.empty())
      diagnostics.add(params().mistake("", "prescribes no component; give at least one of X, Y, Z."));
    if (mesh.dim == 2 && params().has("Z"))
      diagnostics.add(params().mistake("Z", "this body is two-dimensional and has no z displacement."));
  }

  std::vector<Direction> directions(const Mesh&) const override
  {
    std::vector<Direction> all;
    for (const std::size_t axis : axes_)
      all.push_back(axes[axis]);
    return all;
  }

  const std::vector<SampledFunction>& functions() const override { return functions_; }

private:
  std::vector<std::size_t> axes_; ///< the given components, and what is given
  std::vector<SampledFunction> functions_;
};

/// No facets: what holds points or motions prescribes nothing of the continuum.
const std::vector<Facet>& noFacets()
{
  static const std::vector<Facet> none;
  return none;
}

/// Given displacement components at the vertex that lies at a point. In a continuum of two or three dimensions a point
/// can carry no force, so this is for bodies that are in equilibrium without it.
class Point final : public Displacement
{
public:
  explicit Point(const Params& params) : Displacement(params), at_(params.get<std::vector<double>>("At")) {}

  void check(const Mesh& mesh, Diagnostics& diagnostics) const override
  {
    Displacement::check(mesh, diagnostics);
    if (int(at_.size()) != mesh.dim) {
      diagnostics.add(params().mistake(
          "At", fmt::format("At has {} coordinates and the body {} dimensions.", at_.size(), mesh.dim)));
      return;
    }
    const double* const found = mesh.point(nearest(mesh));
    const double tolerance = params().get<double>("Tolerance") * diameter(mesh), apart = distance(found, mesh.dim);
    if (apart > tolerance)
      diagnostics.add(params().mistake(
          "At", fmt::format("no vertex of the mesh lies within {:.3g} of {}; the nearest one is {}, {:.3g} away. Name "
                            "that one, raise Tolerance, or make the mesh with a vertex there.",
                            tolerance, pointText(at_.data(), mesh.dim), pointText(found, mesh.dim), apart)));
  }

  const std::vector<Facet>& facets(const Mesh&) const override { return noFacets(); }

  std::vector<NodeConstraint> constraints(const Mesh& mesh, const NodeMap&) const override
  {
    if (pins_)
      return *pins_;
    const int vertex = nearest(mesh); // its node has the same number
    const auto held = directions(mesh);
    std::vector<NodeConstraint> all;
    for (std::size_t k = 0; k < held.size(); ++k)
      all.push_back({vertex, held[k], valueAt(functions()[k], mesh.dim, mesh.point(vertex))});
    return all;
  }

  void pin(const std::vector<NodeConstraint>& pins) override { pins_ = pins; }

private:
  double distance(const double* x, int dim) const
  {
    double squared = 0.0;
    for (int k = 0; k < dim; ++k)
      squared += std::pow(x[k] - at_[std::size_t(k)], 2);
    return std::sqrt(squared);
  }

  int nearest(const Mesh& mesh) const
  {
    int best = 0;
    for (int p = 1; p < mesh.numPoints(); ++p)
      if (distance(mesh.point(p), mesh.dim) < distance(mesh.point(best), mesh.dim))
        best = p;
    return best;
  }

  std::vector<double> at_;
  std::optional<std::vector<NodeConstraint>> pins_; ///< of a part of a body, which may not have the vertex
};

/// The mean rigid motion of the body, or of a side: among the solutions that differ by motions which nothing resists,
/// the one whose mean motion vanishes. It carries no force, so the loads must be in equilibrium along these motions.
class Hold final : public Support
{
public:
  using Support::Support;
  std::vector<Direction> directions(const Mesh&) const override { return {}; }
  const std::vector<Facet>& facets(const Mesh&) const override { return noFacets(); }
  std::vector<NodeConstraint> constraints(const Mesh&, const NodeMap&) const override { return pins_; }
  bool holdsMeanMotion() const override { return true; }
  void pin(const std::vector<NodeConstraint>& pins) override { pins_ = pins; }

private:
  std::vector<NodeConstraint> pins_;
};

/// A rigid body is where its list says, moved by a given displacement.
class RigidSupport final : public Support
{
public:
  using Support::Support;
  std::string description() const override { return "rigid " + Support::description(); }
  std::vector<Direction> directions(const Mesh& mesh) const override { return {axes.begin(), axes.begin() + mesh.dim}; }
  const std::vector<Facet>& facets(const Mesh&) const override { return noFacets(); }

  std::vector<NodeConstraint> constraints(const Mesh& mesh, const NodeMap& nodes) const override
  {
    const auto moved = params().get<std::vector<double>>("Displacement");
    std::vector<NodeConstraint> all;
    for (int node = 0; node < nodes.numNodes(); ++node)
      for (std::size_t k = 0; k < std::size_t(mesh.dim); ++k)
        all.push_back({node, axes[k], k < moved.size() ? moved[k] : 0.0});
    return all;
  }
};

template <class Component>
auto build()
{
  return [](const Params& p) { return std::make_unique<Component>(p); };
}

} // namespace

std::unique_ptr<Support> makeRigidSupport(const Params& rigid)
{
  return std::make_unique<RigidSupport>(rigid);
}

void registerSupports(Registry<Support>& registry)
{
  registry.add("Clamp", "No displacement at all on a side.", {sideSpec()}, build<Clamp>());
  registry.add("Roller", "No displacement along the normal of a straight or flat side: a symmetry plane.", {sideSpec()},
               build<Roller>());
  registry.add("Displacement", "Prescribed displacement components on a side; components that are not given stay free.",
               {sideSpec(), ParamSpec::optional("X", Kind::Expression, "u_x, a length."),
                ParamSpec::optional("Y", Kind::Expression, "u_y, a length."),
                ParamSpec::optional("Z", Kind::Expression, "u_z, a length (three-dimensional bodies).")},
               build<Displacement>());
  registry.add("Point",
               "Prescribed displacement components at one vertex, for bodies whose loads are in equilibrium without "
               "it: a point cannot carry a force, and a bound is guaranteed only if it carries none.",
               {ParamSpec::required("At", Kind::Doubles, "Coordinates of the vertex."),
                {"Tolerance", 1e-6, above(0.0), "How far from it a vertex may be, relative to the body's diameter."},
                ParamSpec::optional("X", Kind::Expression, "u_x, a length."),
                ParamSpec::optional("Y", Kind::Expression, "u_y, a length."),
                ParamSpec::optional("Z", Kind::Expression, "u_z, a length (three-dimensional bodies).")},
               build<Point>());
  registry.add("Hold",
               "Holds the mean rigid motion as far as neither other supports nor contact do: of the displacements that "
               "differ by such motions it takes the one without a mean motion. It carries no force: loads that are not "
               "in equilibrium along these motions are refused.",
               {ParamSpec::optional("Side", Kind::String, "The mean over this side; without it, over the body.")},
               build<Hold>());
}

} // namespace ndframe

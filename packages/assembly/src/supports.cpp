#include <algorithm>
#include <cmath>

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
    if (found == nullptr)
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
    return {normal(mesh, side(mesh).facets.front())};
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
class Displacement final : public Support
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

template <class Component>
auto build()
{
  return [](const Params& p) { return std::make_unique<Component>(p); };
}

} // namespace

void registerSupports(Registry<Support>& registry)
{
  registry.add("Clamp", "No displacement at all on a side.", {sideSpec()}, build<Clamp>());
  registry.add("Roller", "No displacement along the normal of a straight or flat side: a symmetry plane.", {sideSpec()},
               build<Roller>());
  registry.add("Displacement", "Given displacement components on a side; components that are not given stay free.",
               {sideSpec(), ParamSpec::optional("X", Kind::Expression, "u_x, a length."),
                ParamSpec::optional("Y", Kind::Expression, "u_y, a length."),
                ParamSpec::optional("Z", Kind::Expression, "u_z, a length (three-dimensional bodies).")},
               build<Displacement>());
}

} // namespace ndframe

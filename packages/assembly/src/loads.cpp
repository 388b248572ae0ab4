#include <algorithm>

#include <fmt/format.h>

#include "ndframe/assembly/side_condition.hpp"

namespace ndframe
{
namespace
{

constexpr std::array<const char*, 3> axisNames{"X", "Y", "Z"};

/// t = -p n on a side, equation (3).
class Pressure final : public Load
{
public:
  using Load::Load;

  std::vector<SampledFunction> functions(int) const override { return {sampled("Value")}; }

  void density(int dim, const double* values, const double* normal, double* q) const override
  {
    for (int k = 0; k < dim; ++k)
      q[k] = -values[0] * normal[k];
  }
};

/// A vector given by one expression per component: t on a side, equation (3), or b in the whole body, equation (2).
class VectorLoad final : public Load
{
public:
  using Load::Load;

  void check(const Mesh& mesh, Diagnostics& diagnostics) const override
  {
    Load::check(mesh, diagnostics);
    if (mesh.dim == 2 && params().isGiven("Z"))
      diagnostics.add(params().mistake("Z", "this body is two-dimensional and takes no load along z."));
    for (const std::string& group : groups())
      if (!mesh.groups.has(group))
        diagnostics.add(params().mistake("Cells", fmt::format("the mesh has no group of cells \"{}\".", group)));
  }

  std::vector<std::string> groups() const override
  {
    return params().has("Cells") ? params().get<std::vector<std::string>>("Cells") : std::vector<std::string>();
  }

  std::vector<SampledFunction> functions(int dim) const override
  {
    std::vector<SampledFunction> components;
    for (int k = 0; k < dim; ++k)
      components.push_back(sampled(axisNames[std::size_t(k)]));
    return components;
  }

  void density(int dim, const double* values, const double*, double* q) const override { std::copy_n(values, dim, q); }
};

template <class Component>
auto build()
{
  return [](const Params& p) { return std::make_unique<Component>(p); };
}

std::vector<ParamSpec> components(const char* unit)
{
  std::vector<ParamSpec> specs;
  for (const char* key : axisNames)
    specs.push_back(ParamSpec::expression(key, "0", fmt::format("Component along {}, {}.", key, unit)));
  return specs;
}

} // namespace

void registerLoads(Registry<Load>& registry)
{
  registry.add("Pressure", "A pressure on a side, positive when it pushes on the body.",
               {sideSpec(), ParamSpec::required("Value", Kind::Expression, "The pressure, a stress.")},
               build<Pressure>());
  auto traction = components("a stress");
  traction.insert(traction.begin(), sideSpec());
  registry.add("Traction", "A surface force on a side, by its components.", traction, build<VectorLoad>());
  auto force = components("a stress per length");
  force.push_back(
      {"Cells", std::vector<std::string>{}, "Groups of cells in which it acts, as in Regions. Empty: the whole body."});
  registry.add("Body Force", "A force per volume in the whole body, or in a part of it, by its components.", force,
               build<VectorLoad>());
}

} // namespace ndframe

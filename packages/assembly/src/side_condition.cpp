#include "ndframe/assembly/side_condition.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

#include "ndframe/base/expression.hpp"

namespace ndframe
{

ParamSpec sideSpec()
{
  return ParamSpec::required("Side", Kind::String, "Name of the side of this body's mesh.");
}

std::string sideNames(const Mesh& mesh)
{
  if (mesh.sides.empty())
    return "this mesh has no named sides";
  std::string text = "the sides of this body are: ";
  for (std::size_t s = 0; s < mesh.sides.size(); ++s)
    text += (s == 0 ? "" : ", ") + mesh.sides[s].name;
  return text;
}

std::string pointText(const double* x, int dim)
{
  return dim == 3 ? fmt::format("({:g}, {:g}, {:g})", x[0], x[1], x[2]) : fmt::format("({:g}, {:g})", x[0], x[1]);
}

void SideCondition::check(const Mesh& mesh, Diagnostics& diagnostics) const
{
  if (!params_.has("Side") || mesh.findSide(params_.get<std::string>("Side")) != nullptr)
    return;
  diagnostics.add(params_.mistake(
      "Side", fmt::format("there is no side \"{}\"; {}.", params_.get<std::string>("Side"), sideNames(mesh))));
}

std::string SideCondition::description() const
{
  std::string type = params_.get<std::string>("Type");
  std::transform(type.begin(), type.end(), type.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  if (params_.has("Side"))
    return type + " at " + params_.get<std::string>("Side");
  if (!params_.has("At"))
    return type;
  const auto at = params_.get<std::vector<double>>("At");
  return type + " at " + pointText(at.data(), int(at.size()));
}

const Side& SideCondition::side(const Mesh& mesh) const
{
  const Side* found = mesh.findSide(params_.get<std::string>("Side"));
  NDFRAME_ASSERT(found != nullptr, "side conditions are checked before they are used");
  return *found;
}

SampledFunction sampledFunction(const Params& params, const char* key)
{
  return sampledFunction(ListPlace(params), key, params.expression(key).text());
}

SampledFunction sampledFunction(const ListPlace& list, const char* key, const std::string& text)
{
  return {std::make_shared<const ExpressionTree>(text), [list, key, text](const double* x, int dim, double value) {
            throw InputError(
                list.mistake(key, fmt::format("{} = \"{}\" is {} at {}; it must be finite wherever it is used.", key,
                                              text, std::abs(value), pointText(x, dim))));
          }};
}

bool areConstant(const std::vector<SampledFunction>& functions)
{
  return std::all_of(functions.begin(), functions.end(), [](const auto& f) { return f.tree->isConstant(); });
}

double valueAt(const SampledFunction& function, int dim, const double* point)
{
  const double x[3] = {point[0], point[1], dim == 3 ? point[2] : 0.0};
  double value = 0.0;
  function.tree->values(x, 1, &value);
  if (!std::isfinite(value))
    function.refuse(x, dim, value);
  return value;
}

const std::vector<SampledFunction>& Support::functions() const
{
  static const std::vector<SampledFunction> none;
  return none;
}

bool Support::isConstant() const
{
  return areConstant(functions());
}

std::vector<NodeConstraint> Support::constraints(const Mesh& mesh, const NodeMap& nodes) const
{
  const auto held = directions(mesh);
  std::vector<NodeConstraint> all;
  for (const int node : sideNodes(nodes, side(mesh)))
    for (std::size_t k = 0; k < held.size(); ++k)
      all.push_back(
          {node, held[k], functions().empty() ? 0.0 : valueAt(functions()[k], mesh.dim, nodes.point(node).data())});
  return all;
}

bool Load::isConstant(int dim) const
{
  return areConstant(functions(dim));
}

const std::vector<Facet>* Load::facets(const Mesh& mesh) const
{
  return params().has("Side") ? &side(mesh).facets : nullptr;
}

} // namespace ndframe

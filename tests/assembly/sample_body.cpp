#include "sample_body.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ndframe/algebra/dense.hpp"
#include "ndframe/mesh/partition.hpp"

namespace ndframe::test
{

namespace
{

std::string listXml(const std::string& name, const std::vector<Condition>& conditions)
{
  const auto entry = [](const std::string& key, const std::string& value) {
    return fmt::format("<Parameter name=\"{}\" type=\"string\" value=\"{}\"/>\n", key, value);
  };
  std::string xml = fmt::format("<ParameterList name=\"{}\">\n", name);
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    xml += fmt::format("<ParameterList name=\"{}\">\n", i) + entry("Type", conditions[i].type);
    for (const auto& [key, value] : conditions[i].entries)
      xml += entry(key, value);
    xml += "</ParameterList>\n";
  }
  return xml + "</ParameterList>\n";
}

ListSpec namedChoices(const std::string& name, const Choices& choices)
{
  ListSpec spec;
  spec.name = name;
  spec.each = std::make_shared<ListSpec>();
  spec.each->choices = choices;
  return spec;
}

} // namespace

Condition onSide(const std::string& type, const std::string& side)
{
  return {type, {{"Side", side}}};
}

Elasticity elastic(int dim, Hypothesis planeHypothesis)
{
  const double young = 2.0, nu = 0.3, S = 1.0 / young, G = young / (2.0 * (1.0 + nu));
  const auto stiffness =
      orthotropicStiffness({S, -nu * S, -nu * S, -nu * S, S, -nu * S, -nu * S, -nu * S, S}, {G, G, G});
  return reduceTo(dim == 2 ? planeHypothesis : Hypothesis::ThreeDimensional, *stiffness);
}

BodyModel makeBody(Mesh mesh, int order, const Conditions& conditions)
{
  Registry<Support> supports("support");
  Registry<Load> loads("load");
  registerSupports(supports);
  registerLoads(loads);
  ListSpec spec;
  spec.lists = {namedChoices("Supports", supports.choices()), namedChoices("Loads", loads.choices())};
  Diagnostics diagnostics;
  const auto xml = "<ParameterList name=\"deck\">\n" + listXml("Supports", conditions.supports) +
                   listXml("Loads", conditions.loads) + "</ParameterList>";
  const Params params = validate(parseDeck(xml, "body.xml"), spec, diagnostics);
  diagnostics.throwIfAny();

  BodyModel body;
  body.name = "body";
  body.mesh = std::move(mesh);
  body.nodes = makeNodeMap(body.mesh, order);
  body.laws = elastic(body.mesh.dim);
  for (const auto& support : params.sub("Supports").subs())
    body.supports.push_back(supports.build(support));
  for (const auto& load : params.sub("Loads").subs())
    body.loads.push_back(loads.build(load));
  for (const auto& support : body.supports)
    support->check(body.mesh, diagnostics);
  for (const auto& load : body.loads)
    load->check(body.mesh, diagnostics);
  diagnostics.throwIfAny();
  return body;
}

std::string complaint(const std::function<void()>& step)
{
  try {
    step();
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no InputError";
  return {};
}

std::vector<int> ownedNodes(const BodyModel& body, const Comm& comm)
{
  const auto owner = partitionNodes(body.nodes.cellNodes, body.nodes.nodesPerCell, body.nodes.numNodes(), comm.size());
  std::vector<int> owned;
  for (int node = 0; node < body.nodes.numNodes(); ++node)
    if (owner[std::size_t(node)] == comm.rank())
      owned.push_back(node);
  return owned;
}

ConstraintSet constraintsOf(const BodyModel& body)
{
  return collectConstraints(body.supports, body.mesh, body.nodes);
}

BodySystem assemble(const BodyModel& body, const Comm& comm)
{
  return assembleBody(body, makeDofLayout(body.nodes, constraintsOf(body), {}), ownedNodes(body, comm));
}

Vector interpolate(const NodeMap& nodes, const std::function<void(const double*, double*)>& field)
{
  Vector u(std::size_t(nodes.numNodes()) * std::size_t(nodes.dim));
  for (int node = 0; node < nodes.numNodes(); ++node)
    field(nodes.point(node).data(), u.data() + node * nodes.dim);
  return u;
}

NodalField solve(const BodySystem& system, const Comm& comm)
{
  std::vector<std::size_t> free;
  for (std::size_t dof = 0; dof < system.dofs.roles.size(); ++dof)
    if (system.dofs.roles[dof] != DofRole::Fixed)
      free.push_back(dof);
  DenseMatrix K(int(free.size()), int(free.size()));
  for (std::size_t j = 0; j < free.size(); ++j) {
    Vector unit(system.load.size(), 0.0);
    unit[free[j]] = 1.0;
    const Vector column = multiply(system.K, unit, comm);
    for (std::size_t i = 0; i < free.size(); ++i)
      K(int(i), int(j)) = column[free[i]];
  }
  const Vector load = system.effectiveLoad(comm).all().whole();
  Vector rhs;
  for (const std::size_t dof : free)
    rhs.push_back(load[dof]);
  const Vector x = DenseCholesky(K).solve(rhs);
  Vector u(load.size(), 0.0);
  system.dofs.addPrescribed(u);
  for (std::size_t i = 0; i < free.size(); ++i)
    u[free[i]] = x[i];
  return system.dofs.frames.toGlobal(u);
}

double largest(const Vector& values)
{
  double value = 0.0;
  for (const double v : values)
    value = std::max(value, std::abs(v));
  return value;
}

} // namespace ndframe::test

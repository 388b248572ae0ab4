#include "interface/box_bodies.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "algebra/sample_bodies.hpp"
#include "common/test_main.hpp"
#include "ndframe/interface/applied_operator.hpp"
#include "ndframe/mechanics/material_law.hpp"
#include "ndframe/mesh/refine.hpp"
#include "ndframe/meshing/mesh_source.hpp"

namespace ndframe::test
{

namespace
{

std::string entry(const std::string& key, const std::string& type, const std::string& value)
{
  return fmt::format("<Parameter name=\"{}\" type=\"{}\" value=\"{}\"/>\n", key, type, value);
}

Params validated(const std::string& entries, const ListSpec& spec, const std::string& name)
{
  Diagnostics diagnostics;
  Params params = validate(parseDeck(list(name, entries), "test.xml"), spec, diagnostics);
  diagnostics.throwIfAny();
  return params;
}

template <class Product>
ListSpec choiceSpec(const std::string& name, const Registry<Product>& registry)
{
  ListSpec spec;
  spec.name = name;
  spec.choices = registry.choices();
  return spec;
}

std::vector<int> allNodes(const NodeMap& nodes)
{
  std::vector<int> all(static_cast<std::size_t>(nodes.numNodes()));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

class AppliedOnly final : public AppliedOperator
{
public:
  AppliedOnly(DenseMatrix A, double tolerance) : AppliedOperator(tolerance), A_(std::move(A)) {}
  int size() const override { return A_.rows(); }
  Vector apply(const Vector& x) const override { return multiply(A_, x); }

private:
  DenseMatrix A_;
};

} // namespace

std::string doubles(const std::string& key, const std::string& values)
{
  return entry(key, "Array(double)", "{" + values + "}");
}
std::string ints(const std::string& key, const std::string& values)
{
  return entry(key, "Array(int)", "{" + values + "}");
}
std::string text(const std::string& key, const std::string& value)
{
  return entry(key, "string", value);
}
std::string list(const std::string& name, const std::string& entries)
{
  return fmt::format("<ParameterList name=\"{}\">\n{}</ParameterList>\n", name, entries);
}

std::string box(const std::string& lower, const std::string& upper, const std::string& cells)
{
  return doubles("Lower", lower) + doubles("Upper", upper) + ints("Cells", cells);
}

BodyModel boxBody(const std::string& name, const std::string& meshEntries, int order, const std::string& supports)
{
  Registry<MeshSource> meshSources("mesh", "Box");
  registerMeshSources(meshSources);
  Registry<MaterialLaw> materials("material", "Isotropic");
  registerMaterials(materials);
  Registry<ndframe::Support> supportTypes("support");
  registerSupports(supportTypes);
  ListSpec supportList;
  supportList.name = "Supports";
  supportList.each = std::make_shared<ListSpec>(choiceSpec("SUPPORT", supportTypes));
  ListSpec spec;
  spec.lists = {choiceSpec("Mesh", meshSources), supportList};
  const Params params = validated(list("Mesh", meshEntries) + list("Supports", supports), spec, name);

  BodyModel body;
  body.name = name;
  body.mesh = meshSources.build(params.sub("Mesh"))->read();
  const std::string hypothesis = body.mesh.dim == 2 ? "Plane Strain" : "Three Dimensional";
  const std::string material =
      entry("Young Modulus", "double", "2") + entry("Poisson Ratio", "double", "0.3") + text("Hypothesis", hypothesis);
  body.laws = materials.build(validated(material, choiceSpec("Material", materials), "Material"))->elasticity();
  body.nodes = makeNodeMap(body.mesh, order);
  for (const auto& support : params.sub("Supports").subs())
    body.supports.push_back(supportTypes.build(support));
  return body;
}

BodyModel renumbered(const BodyModel& body)
{
  BodyModel result;
  result.name = body.name;
  result.laws = body.laws;
  result.mesh = body.mesh;
  Mesh& mesh = result.mesh;
  const int dim = mesh.dim, numPoints = mesh.numPoints(), numCells = mesh.numCells();
  for (int p = 0; p < numPoints; ++p)
    std::copy_n(body.mesh.point(numPoints - 1 - p), dim, mesh.points.begin() + p * dim);
  for (int c = 0; c < numCells; ++c)
    for (int a = 0; a <= dim; ++a)
      mesh.cells[std::size_t(c * (dim + 1) + a)] = numPoints - 1 - body.mesh.cell(numCells - 1 - c)[a];
  for (auto& side : mesh.sides) {
    for (auto& facet : side.facets)
      facet.cell = numCells - 1 - facet.cell;
    std::rotate(side.facets.begin(), side.facets.begin() + std::ptrdiff_t(side.facets.size() / 2), side.facets.end());
  }
  result.nodes = makeNodeMap(mesh, body.nodes.order);
  return result;
}

InterfaceSettings interfaceEntry(const std::string& dirichletSide, const std::string& neumannSide,
                                 const std::string& gap, double cornerAngle)
{
  InterfaceSettings settings;
  settings.place = settings.pairing = ListPlace(validated({}, {}, "contact"));
  settings.name = "contact";
  settings.dirichletSide = dirichletSide;
  settings.neumannSide = neumannSide;
  settings.gap = gap;
  settings.cornerAngle = cornerAngle;
  return settings;
}

CondensedBox::CondensedBox(const BodyModel& model, const std::vector<TraceNormal>& traces)
    : constraints(collectConstraints(model.supports, model.mesh, model.nodes)),
      system(assembleBody(model, makeDofLayout(model.nodes, constraints, traces), allNodes(model.nodes)))
{
  problem.matrix = &system.K;
  problem.roles = system.dofs.roles;
  problem.kept = system.dofs.keptDofs();
  problem.nearNullSpace = rigidModes(rigidBasis(model.mesh), model.nodes, system.dofs.frames);
  problem.nodePoints = nodePoints(model.nodes);
  condensed = makeSolver("Cholmod")->factor(problem, comm(), ledger);
}

std::unique_ptr<InterfaceOperator> makeInterfaceOperator(const std::string& type, const std::string& entries)
{
  Registry<InterfaceOperator> registry("interface operator", "Automatic");
  registerInterfaceOperators(registry);
  return registry.build(
      validated(text("Type", type) + entries, choiceSpec("Interface Operator", registry), "operator"));
}

std::shared_ptr<const SymmetricOperator> appliedOnly(DenseMatrix A, double tolerance)
{
  return std::make_shared<AppliedOnly>(std::move(A), tolerance);
}

InterfaceMesh straightInterface(const std::vector<double>& x, int order)
{
  const int elements = int(x.size()) - 1;
  InterfaceMesh interface;
  interface.dim = 2;
  interface.order = order;
  const int nodes = elements * order + 1;
  for (int i = 0; i < nodes; ++i) {
    const auto e = std::size_t(i / order);
    const double along = i % order == 0 ? x[e] : 0.5 * (x[e] + x[e + 1]);
    interface.points.insert(interface.points.end(), {along, 0.0});
    interface.normals.push_back({0.0, -1.0, 0.0});
    interface.gap.push_back(0.0);
    interface.sides[0].nodes.push_back(i);
    interface.sides[1].nodes.push_back(i);
  }
  for (int e = 0; e < elements; ++e) {
    interface.measures.push_back(x[std::size_t(e + 1)] - x[std::size_t(e)]);
    interface.facets.insert(interface.facets.end(), {e * order, (e + 1) * order});
    if (order == 2)
      interface.facets.push_back(2 * e + 1);
  }
  return interface;
}

void refine(BodyModel& body)
{
  body.mesh = refineUniformly(body.mesh);
  body.nodes = makeNodeMap(body.mesh, body.nodes.order);
}

} // namespace ndframe::test

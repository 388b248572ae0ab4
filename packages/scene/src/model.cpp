#include "ndframe/scene/model.hpp"

#include <map>
#include <numeric>

#include <fmt/format.h>

#include "match_sides.hpp"
#include "ndframe/base/help.hpp"
#include "ndframe/interface/normal_field.hpp"
#include "ndframe/scene/holds.hpp"
#include "ndframe/scene/regions.hpp"
#include "ndframe/scene/shared_mesh.hpp"
#include "ndframe/scene/stage.hpp"

namespace ndframe
{
namespace
{

/// Builds one body; mistakes are collected and leave the body incomplete.
BodyModel buildBody(const Params& params, const SceneComponents& components, CutMesh given, int order,
                    Diagnostics& diagnostics)
{
  BodyModel body;
  body.name = params.name();
  body.mesh = std::move(given.mesh);
  body.base = std::move(given.base);
  body.parents = std::move(given.parents);
  takeMaterials(body, params, components, diagnostics);
  body.nodes = given.nodes.numNodes() > 0 ? std::move(given.nodes) : makeNodeMap(body.mesh, order);
  for (const auto& support : params.sub("Supports").subs())
    body.supports.push_back(components.supports.build(support));
  for (const auto& load : params.sub("Loads").subs())
    body.loads.push_back(components.loads.build(load));
  for (const auto& support : body.supports)
    support->check(body.mesh, diagnostics);
  for (const auto& load : body.loads)
    load->check(body.mesh, diagnostics);
  return body;
}

/// Groups of cells mean nothing to a body without regions.
GivenMesh withoutIdleGroups(GivenMesh given, const Params& body)
{
  if (!body.hasSub("Regions"))
    given.mesh.groups = {};
  return given;
}

/// Runs `step`, moving an InputError into the collection.
template <class Step>
void collecting(Diagnostics& diagnostics, const Step& step)
{
  try {
    step();
  } catch (const InputError& error) {
    for (const auto& diagnostic : error.list())
      diagnostics.add(diagnostic);
  }
}

/// The integrals of all loads. Those that are not finite somewhere are found before anything is solved.
Vector evaluateLoads(const BodyModel& body, Diagnostics& diagnostics)
{
  Vector sum(std::size_t(body.numDofs()), 0.0);
  for (const auto& load : body.loads)
    collecting(diagnostics, [&] { load->addTo(sum, body.mesh, body.nodes); });
  return sum;
}

/// Counts what evaluateLoads() integrated over cells.
void countBodyForces(const Model& model, Ledger& ledger)
{
  for (const auto& body : model.bodies)
    for (const auto& load : body.loads)
      if (load->facets(body.mesh) == nullptr)
        ledger.count("body force integrals", body.mesh.numCells());
}

int findBody(const Model& model, const Params& definition, const char* key, Diagnostics& diagnostics)
{
  const auto name = definition.get<std::string>(key);
  const int index = model.bodyIndex(name);
  if (index >= 0)
    return index;
  std::vector<std::string> names;
  for (const auto& body : model.bodies)
    names.push_back(body.name);
  const auto nearest = nearestName(name, names);
  diagnostics.add(
      definition.mistake(key, fmt::format("there is no body \"{}\"; {}", name,
                                          nearest.empty() ? fmt::format("the bodies are: {}.", fmt::join(names, ", "))
                                                          : fmt::format("did you mean \"{}\"?", nearest))));
  return -1;
}

/// A side that is the polygon it was before keeps the normals of the mesh that it had first.
void keepNormals(InterfaceMesh& interface, const std::vector<InterfaceMesh>& earlier)
{
  for (const InterfaceMesh& before : earlier) {
    if (before.name != interface.name || before.endNormals.empty())
      continue;
    auto first = before.firstMesh ? before.firstMesh : std::make_shared<const InterfaceMesh>(before);
    if (inheritNormals(interface, *first))
      interface.firstMesh = std::move(first);
  }
}

/// Per interface node whether supports hold neither of its bodies there.
std::vector<char> withoutSupports(const Model& model, const InterfaceMesh& interface)
{
  const auto isHeld = [&](int body, int node) { return model.constraints[std::size_t(body)].nodes().count(node) > 0; };
  std::vector<char> without;
  for (std::size_t i = 0; i < std::size_t(interface.numNodes()); ++i)
    without.push_back(!isHeld(interface.dirichletBody, interface.dirichletNodes[i]) &&
                      !isHeld(interface.neumannBody, interface.neumannNodes[i]));
  return without;
}

void addInterface(Model& model, const Params& definition, std::shared_ptr<const SideMap> map,
                  const std::vector<InterfaceMesh>& earlier, Diagnostics& diagnostics)
{
  const int first = findBody(model, definition, "Dirichlet Body", diagnostics);
  const int second = findBody(model, definition, "Neumann Body", diagnostics);
  if (first < 0 || second < 0)
    return;
  const auto &dirichlet = model.bodies[std::size_t(first)], &neumann = model.bodies[std::size_t(second)];
  if (first == second)
    throw InputError(definition.mistake("Neumann Body", "a body cannot touch itself; name two different bodies."));
  if (dirichlet.mesh.dim != neumann.mesh.dim)
    throw InputError(definition.mistake("", fmt::format("\"{}\" is {}-D and \"{}\" is {}-D.", dirichlet.name,
                                                        dirichlet.mesh.dim, neumann.name, neumann.mesh.dim)));
  if (dirichlet.mesh.dim == 3)
    throw InputError(definition.mistake("",
                                        "contact between three-dimensional bodies is not available in this version; "
                                        "three-dimensional bodies can be solved alone."));
  InterfaceMesh interface =
      map ? pairFacing(definition, dirichlet, neumann, std::move(map)) : pairSides(definition, dirichlet, neumann);
  if (!interface.map)
    keepNormals(interface, earlier);
  interface.dirichletBody = interface.firstBody = first;
  interface.neumannBody = second;
  if (diagnostics.empty()) // else constraints may be missing
    splitCorners(interface, dirichlet.mesh, definition.get<double>("Corner Angle"), withoutSupports(model, interface));
  addDrawnGap(definition, interface);
  model.interfaces.push_back(std::move(interface));
}

/// A facet touches one other body.
void refuseSharedFacets(const Model& model, const Params& deck, Diagnostics& diagnostics)
{
  std::map<std::array<int, 3>, const InterfaceMesh*> taken; // by body, cell and local number
  for (const auto& interface : model.interfaces)
    for (const auto& [body, facets] : {std::pair(interface.dirichletBody, &interface.dirichletFacets),
                                       std::pair(interface.neumannBody, &interface.neumannFacets)})
      for (const Facet facet : *facets) {
        const auto [before, isNew] = taken.insert({{body, facet.cell, facet.local}, &interface});
        if (isNew)
          continue;
        const BodyModel& owner = model.bodies[std::size_t(body)];
        diagnostics.add(deck.sub("Interfaces")
                            .sub(interface.name)
                            .mistake("", fmt::format("contains the facet at {} of \"{}\", which \"{}\" contains, too; "
                                                     "leave it out of one of them (split the side).",
                                                     pointText(facetCentre(owner.mesh, facet).data(), owner.mesh.dim),
                                                     owner.name, before->second->name)));
        return;
      }
}

void refuseIdleInterfaces(const Model& model, const Params& deck, Diagnostics& diagnostics)
{
  for (const auto& interface : model.interfaces) {
    bool carries = false;
    for (int i = 0; i < interface.numNodes(); ++i)
      carries = carries || model.carriesContact(interface, i);
    if (!carries)
      diagnostics.add(deck.sub("Interfaces")
                          .sub(interface.name)
                          .mistake("", "supports prescribe the normal displacement of every node on both sides: "
                                       "contact has nothing to decide here."));
  }
}

} // namespace

std::vector<int> Model::numDofs() const
{
  std::vector<int> numbers;
  for (const auto& body : bodies)
    numbers.push_back(body.numDofs());
  return numbers;
}

std::int64_t Model::totalDofs() const
{
  const std::vector<int> numbers = numDofs();
  return std::accumulate(numbers.begin(), numbers.end(), std::int64_t(0));
}

int Model::bodyIndex(const std::string& name) const
{
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (bodies[b].name == name)
      return int(b);
  return -1;
}

Model buildModel(const Params& deck, const SceneComponents& components)
{
  return buildModel(deck, components,
                    [&](const Params& body) { return components.meshSources.build(body.sub("Mesh"))->read(); });
}

void updateModel(Model& model, const Params& deck, const SceneComponents& components, const Comm& comm, Ledger& ledger)
{
  SceneRecipe recipe = recipeOf(deck);
  if (recipe.sameModel(model.recipe)) {
    ledger.count("meshes reused", std::int64_t(recipe.bodies.size()));
    model.recipe = std::move(recipe);
    return;
  }
  const auto timer = timeStage(ledger, Stage::Read);
  const bool comparable = recipe.bodies.size() == model.recipe.bodies.size();
  std::size_t next = 0;
  Model updated = buildModel(deck, components, [&](const Params& body) -> GivenMesh {
    const std::size_t b = next++;
    if (!comparable || recipe.bodies[b].mesh != model.recipe.bodies[b].mesh)
      return readShared(*components.meshSources.build(body.sub("Mesh")), comm);
    ledger.count("meshes reused");
    const BodyModel& known = model.bodies[b];
    return known.parents.empty() ? GivenMesh(known.mesh, known.nodes) : GivenMesh(known.base);
  });
  updated.recipe = std::move(recipe);
  countBodyForces(updated, ledger);
  model = std::move(updated);
}

void remeshModel(Model& model, const Params& deck, const SceneComponents& components, const MeshOfBody& meshOf,
                 Ledger& ledger)
{
  const auto timer = timeStage(ledger, Stage::Read);
  model = buildModel(deck, components, meshOf, model.interfaces);
  countBodyForces(model, ledger);
}

Model buildModel(const Params& deck, const SceneComponents& components, const MeshOfBody& meshOf,
                 const std::vector<InterfaceMesh>& earlier)
{
  Model model;
  Diagnostics diagnostics;
  const int order = deck.sub("Discretization").get<int>("Order");
  if (deck.sub("Bodies").subs().empty())
    diagnostics.add(deck.sub("Bodies").mistake("", "has no bodies; name at least one list in it."));
  std::vector<CutMesh> meshes;
  for (const auto& params : deck.sub("Bodies").subs())
    collecting(diagnostics, [&] { meshes.emplace_back(withoutIdleGroups(meshOf(params), params)); });
  diagnostics.throwIfAny();
  const auto maps = matchSides(deck, earlier, meshes);
  for (std::size_t b = 0; b < meshes.size(); ++b)
    collecting(diagnostics, [&] {
      const Params params = deck.sub("Bodies").subs()[b];
      model.bodies.push_back(buildBody(params, components, std::move(meshes[b]), order, diagnostics));
    });
  diagnostics.throwIfAny();
  for (const auto& body : model.bodies)
    collecting(diagnostics,
               [&] { model.constraints.push_back(collectConstraints(body.supports, body.mesh, body.nodes)); });
  for (const auto& body : model.bodies)
    model.loads.push_back(evaluateLoads(body, diagnostics));
  for (const auto& definition : deck.sub("Interfaces").subs())
    collecting(diagnostics, [&] { addInterface(model, definition, maps.at(definition.name()), earlier, diagnostics); });
  diagnostics.throwIfAny();
  refuseSharedFacets(model, deck, diagnostics);
  refuseIdleInterfaces(model, deck, diagnostics);
  diagnostics.throwIfAny();
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    model.rigid.push_back(rigidBasis(model.bodies[b].mesh));
    model.freeMotions.push_back(
        nullSpace(supportRows(model.rigid[b], model.bodies[b].nodes, model.constraints[b]), rigidTolerance));
  }
  resolveHolds(model, deck, diagnostics);
  diagnostics.throwIfAny();
  return model;
}

} // namespace ndframe

#include "ndframe/scene/model.hpp"

#include <algorithm>
#include <limits>

#include "add_interface.hpp"
#include "ndframe/algebra/threads.hpp"
#include "ndframe/assembly/body_loads.hpp"
#include "ndframe/scene/holds.hpp"
#include "ndframe/scene/regions.hpp"
#include "ndframe/scene/shared_mesh.hpp"
#include "ndframe/scene/stage.hpp"

namespace ndframe
{
namespace
{

void refuseConditions(const BodySettings& rigid, Diagnostics& diagnostics)
{
  for (const ListPlace& list : rigid.idle)
    diagnostics.add(list.mistake(
        "", "has no meaning for a rigid body, which is where its list Rigid says; remove one of the two."));
}

/// Builds one body; mistakes are collected and leave the body incomplete. whole: the regions of a body of which it is a
/// share.
BodyModel buildBody(const BodySettings& settings, const SceneComponents& components, CutMesh given, int order,
                    const std::vector<BodyRegion>* whole, Diagnostics& diagnostics)
{
  BodyModel body;
  body.name = settings.name;
  body.mesh = std::move(given.mesh);
  body.base = std::move(given.base);
  body.parents = std::move(given.parents);
  body.uncutPoints = given.uncutPoints;
  body.drawn = std::move(given.drawn);
  body.isRigid = settings.isRigid;
  body.share = std::move(given.share);
  if (body.isRigid) {
    body.supports.push_back(makeRigidSupport(settings.shape));
    refuseConditions(settings, diagnostics);
  } else {
    takeMaterials(body, settings, components, whole, diagnostics);
  }
  body.nodes = given.nodes.numNodes() > 0 ? std::move(given.nodes) : makeNodeMap(body.mesh, order);
  for (const Params& support : settings.supports)
    body.supports.push_back(components.supports.build(support));
  for (const Params& load : settings.loads)
    body.loads.push_back(components.loads.build(load));
  if (body.share) // the whole is checked
    return body;
  for (const auto& support : body.supports)
    support->check(body.mesh, diagnostics);
  for (const auto& load : body.loads)
    load->check(body.mesh, diagnostics);
  return body;
}

/// Rigid motions of the bodies, and what holds them.
void findMotions(Model& model, const SceneSettings& scene, Diagnostics& diagnostics)
{
  if (model.told) {
    model.rigid = model.told->rigid;
    model.freeMotions = model.told->freeMotions;
    model.balancedMotions = model.told->balancedMotions;
    takeHolds(model);
    return;
  }
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    model.rigid.push_back(rigidBasis(model.bodies[b].mesh));
    model.freeMotions.push_back(
        nullSpace(supportRows(model.rigid[b], model.bodies[b].nodes, model.constraints[b]), rigidTolerance));
  }
  resolveHolds(model, scene, diagnostics);
  diagnostics.throwIfAny();
}

/// Groups of cells mean nothing to a body whose regions and loads name none.
GivenMesh withoutIdleGroups(GivenMesh given, const BodySettings& body)
{
  if (!body.namesCells)
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

/// Per body the integrals of all its loads; threads compute their parts side by side where some have to be sampled.
/// Loads that are not finite somewhere are found before anything is solved.
std::vector<SparseField> evaluateLoads(const std::vector<BodyModel>& bodies, Load::Keep keep, int threads,
                                       Diagnostics& diagnostics)
{
  std::vector<BodyLoads> loads;
  std::vector<std::pair<std::size_t, int>> parts; // of bodies
  bool areSampled = false;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    loads.emplace_back(bodies[b], keep);
    for (int part = 0; part < loads.back().numParts(); ++part)
      parts.emplace_back(b, part);
    areSampled = areSampled || loads.back().areSampled();
  }
  runConcurrently(int(parts.size()), areSampled ? threads : 1, [&](int task) {
    const auto [body, part] = parts[std::size_t(task)];
    loads[body].compute(part);
  });
  std::vector<SparseField> sums(bodies.size());
  for (std::size_t b = 0; b < bodies.size(); ++b)
    collecting(diagnostics, [&] { sums[b] = SparseField(loads[b].take()); });
  return sums;
}

/// Counts what evaluateLoads() integrated over cells.
void countBodyForces(const Model& model, Ledger& ledger)
{
  for (const auto& body : model.bodies)
    for (const auto& load : body.loads)
      if (load->facets(body.mesh) == nullptr)
        ledger.count("body force integrals", body.mesh.numCells());
}

/// What the deck says, or, Automatic, Bernstein in space and Nodal in the plane.
ContactConditions conditionsOf(const SceneSettings& scene, int dim)
{
  return scene.conditions.value_or(dim == 3 ? ContactConditions::Bernstein : ContactConditions::Nodal);
}

/// What the interfaces of a scene can only be told together.
void checkInterfaces(Model& model, const SceneSettings& scene, Diagnostics& diagnostics)
{
  const int dim = model.bodies.front().mesh.dim;
  model.conditions = conditionsOf(scene, dim);
  if (dim == 3 && model.conditions == ContactConditions::Nodal && scene.order == 2 && !model.interfaces.empty())
    diagnostics.add(scene.discretization.mistake("Contact Conditions",
                                                 "in 3D the vertices of second order carry no load, and nodal "
                                                 "conditions are noise there; use Bernstein (or Automatic)."));
  refuseSharedFacets(model, scene, diagnostics);
  refuseIdleInterfaces(model, scene, diagnostics);
  diagnostics.throwIfAny();
}

} // namespace

std::vector<int> Model::numDofs() const
{
  std::vector<int> numbers;
  for (const auto& body : bodies)
    numbers.push_back(int(std::min(body.totalDofs(), std::int64_t(std::numeric_limits<int>::max()))));
  return numbers;
}

std::int64_t Model::totalDofs() const
{
  std::int64_t total = 0;
  for (const int b : elasticBodies())
    total += bodies[std::size_t(b)].totalDofs();
  return total;
}

int Model::bodyIndex(const std::string& name) const
{
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (bodies[b].name == name)
      return int(b);
  return -1;
}

bool Model::touches(int body) const
{
  return std::any_of(interfaces.begin(), interfaces.end(), [body](const InterfaceMesh& interface) {
    return interface.dirichlet().body == body || interface.neumann().body == body;
  });
}

double Model::diameterOf(int body) const
{
  return told ? told->diameters[std::size_t(body)] : diameter(bodies[std::size_t(body)].mesh);
}

BodyOutline Model::outline(int body) const
{
  BodyOutline outline{bodies[std::size_t(body)].mesh.dim, 0, 0, touches(body) && !solvesWhole, 0.0};
  for (const int one : elasticBodies())
    if (one == body || (solvesWhole && touches(body) && touches(one))) {
      outline.dofs += bodies[std::size_t(one)].totalDofs();
      ++outline.bodies;
      outline.poissonRatio = std::max(outline.poissonRatio, bodies[std::size_t(one)].poissonRatio());
    }
  return outline;
}

std::vector<int> Model::elasticBodies() const
{
  std::vector<int> numbers;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (!bodies[b].isRigid)
      numbers.push_back(int(b));
  return numbers;
}

Model buildModel(const SceneSettings& scene, const SceneComponents& components)
{
  Ledger nobody;
  ScriptMeshes scripts(nobody);
  return buildModel(scene, components, [&](const BodySettings& body) -> GivenMesh {
    if (body.isRigid)
      return Mesh();
    return readShared(*components.meshSources.build(body.shape), Comm::single(), scripts);
  });
}

void updateModel(Model& model, const SceneSettings& scene, const SceneComponents& components, const Comm& comm,
                 Ledger& ledger, std::vector<Mesh> drawn)
{
  SceneRecipe recipe = recipeOf(scene);
  if (recipe.sameModel(model.recipe)) {
    ledger.count("meshes reused", std::int64_t(recipe.bodies.size()));
    model.recipe = std::move(recipe);
    return;
  }
  const auto timer = timeStage(ledger, Stage::Read);
  const bool comparable = recipe.bodies.size() == model.recipe.bodies.size();
  std::size_t next = 0;
  ScriptMeshes scripts(ledger);
  drawn.resize(recipe.bodies.size());
  Model updated = buildModel(
      scene, components,
      [&](const BodySettings& body) -> GivenMesh {
        const std::size_t b = next++;
        if (body.isRigid)
          return Mesh();
        if (!comparable || recipe.bodies[b].mesh != model.recipe.bodies[b].mesh)
          return readShared(*components.meshSources.build(body.shape), comm, scripts, std::move(drawn[b]));
        ledger.count("meshes reused");
        const BodyModel& known = model.bodies[b];
        return known.parents.empty() ? GivenMesh(known.mesh, known.nodes, known.drawn)
                                     : GivenMesh(known.base, {}, known.drawn);
      },
      {}, numThreads(comm));
  updated.recipe = std::move(recipe);
  countBodyForces(updated, ledger);
  model = std::move(updated);
}

void remeshModel(Model& model, const SceneSettings& scene, const SceneComponents& components, const MeshOfBody& meshOf,
                 const Comm& comm, Ledger& ledger)
{
  const auto timer = timeStage(ledger, Stage::Read);
  model = buildModel(scene, components, meshOf, model.interfaces, numThreads(comm));
  countBodyForces(model, ledger);
}

Model buildModel(const SceneSettings& scene, const SceneComponents& components, const MeshOfBody& meshOf,
                 const std::vector<InterfaceMesh>& earlier, int threads, std::shared_ptr<const ToldScene> told)
{
  Model model;
  model.told = std::move(told);
  Diagnostics diagnostics;
  if (scene.bodies.empty())
    diagnostics.add(scene.bodiesPlace.mistake("", "has no bodies; name at least one list in it."));
  std::vector<CutMesh> meshes;
  for (const BodySettings& body : scene.bodies)
    collecting(diagnostics, [&] { meshes.emplace_back(withoutIdleGroups(meshOf(body), body)); });
  diagnostics.throwIfAny();
  for (const CutMesh& mesh : meshes)
    model.inside.push_back(mesh.inside);
  const auto pairings = matchSides(scene, components, earlier, meshes, model.told.get());
  for (std::size_t b = 0; b < meshes.size(); ++b)
    collecting(diagnostics, [&] {
      model.bodies.push_back(buildBody(scene.bodies[b], components, std::move(meshes[b]), scene.order,
                                       model.told ? &model.told->regions[b] : nullptr, diagnostics));
    });
  diagnostics.throwIfAny();
  if (model.told)
    takePins(model.bodies, *model.told);
  for (const auto& body : model.bodies)
    collecting(diagnostics,
               [&] { model.constraints.push_back(collectConstraints(body.supports, body.mesh, body.nodes)); });
  const auto keep = scene.certifies ? Load::Keep::Projections : Load::Keep::Nothing;
  model.loads = evaluateLoads(model.bodies, keep, threads, diagnostics);
  for (const InterfaceSettings& interface : scene.interfaces)
    collecting(diagnostics, [&] { addInterface(model, interface, pairings.at(interface.name), earlier, diagnostics); });
  diagnostics.throwIfAny();
  checkInterfaces(model, scene, diagnostics);
  findMotions(model, scene, diagnostics);
  return model;
}

} // namespace ndframe

#include <algorithm>

#include <fmt/format.h>

#include "ndframe/mesh/refine.hpp"
#include "ndframe/meshing/refined_source.hpp"
#include "ndframe/scene/shared_scene.hpp"
#include "ndframe/scene/stage.hpp"

namespace ndframe
{
namespace
{

constexpr int verticesOfRank = 200; ///< METIS shares out fewer unevenly

bool haveEnough(const std::vector<Mesh>& meshes, int ranks)
{
  std::int64_t vertices = 0;
  for (const Mesh& mesh : meshes)
    vertices += mesh.numPoints();
  return vertices >= std::int64_t(verticesOfRank) * ranks;
}

/// The mesh that an earlier model has of a body, if it is the one that is drawn.
const Mesh* knownMesh(const Model& known, const SceneRecipe& recipe, std::size_t body)
{
  const auto& before = known.recipe.bodies;
  return before.size() == recipe.bodies.size() && before[body].mesh == recipe.bodies[body].mesh
             ? &known.bodies[body].uncut()
             : nullptr;
}

void refine(DrawnScene& drawn, std::size_t body)
{
  Mesh refined = refineUniformly(drawn.meshes[body]);
  if (!drawn.before[body])
    drawn.before[body] = std::make_shared<const Mesh>(std::move(drawn.meshes[body]));
  drawn.meshes[body] = std::move(refined);
  --drawn.halvings[body];
}

/// Bodies that touch get as many halvings to come: their sides match in the end if they match now.
void refineAlike(DrawnScene& drawn, const SceneSettings& scene)
{
  const auto bodyOf = [&](const std::string& name) {
    return std::size_t(std::find_if(scene.bodies.begin(), scene.bodies.end(),
                                    [&](const BodySettings& body) { return body.name == name && !body.isRigid; }) -
                       scene.bodies.begin());
  };
  for (bool isAlike = false; !isAlike;) {
    isAlike = true;
    for (const InterfaceSettings& interface : scene.interfaces) {
      const std::size_t a = bodyOf(interface.dirichletBody), b = bodyOf(interface.neumannBody);
      if (a == scene.bodies.size() || b == scene.bodies.size() || drawn.halvings[a] == drawn.halvings[b])
        continue;
      refine(drawn, drawn.halvings[a] > drawn.halvings[b] ? a : b);
      isAlike = false;
    }
  }
}

/// All of them, with all mistakes.
std::vector<Mesh> readMeshes(const SceneSettings& scene, const SceneComponents& components, const Model& known,
                             Ledger& ledger)
{
  const SceneRecipe recipe = recipeOf(scene);
  ScriptMeshes scripts(ledger);
  Diagnostics diagnostics;
  std::vector<Mesh> meshes(scene.bodies.size());
  for (std::size_t b = 0; b < meshes.size(); ++b) {
    const BodySettings& body = scene.bodies[b];
    if (body.isRigid)
      continue;
    try {
      const Mesh* before = halvingsOf(body.shape) == 0 ? knownMesh(known, recipe, b) : nullptr;
      meshes[b] = before ? *before : components.meshSources.build(body.shape)->drawn().readWith(scripts);
    } catch (const InputError& error) {
      for (const Diagnostic& mistake : error.list())
        diagnostics.add(mistake);
    }
  }
  diagnostics.throwIfAny();
  return meshes;
}

} // namespace

DrawnScene readDrawn(const SceneSettings& scene, const SceneComponents& components, const Model& known, int ranks,
                     Ledger& ledger)
{
  const auto timer = timeStage(ledger, Stage::Read);
  DrawnScene drawn;
  drawn.meshes = readMeshes(scene, components, known, ledger);
  for (const BodySettings& body : scene.bodies)
    drawn.halvings.push_back(body.isRigid ? 0 : halvingsOf(body.shape));
  drawn.before.resize(drawn.meshes.size());
  refineAlike(drawn, scene);
  for (bool isRefined = true; isRefined && !haveEnough(drawn.meshes, ranks);) {
    isRefined = false;
    for (std::size_t b = 0; b < drawn.meshes.size(); ++b)
      if (drawn.halvings[b] > 1) {
        refine(drawn, b);
        isRefined = true;
      }
  }
  for (std::size_t b = 0; b < drawn.meshes.size() && areEnough(drawn, ranks); ++b)
    drawn.numbers.emplace_back(drawn.meshes[b], drawn.halvings[b]);
  return drawn;
}

bool areEnough(const DrawnScene& drawn, int ranks)
{
  bool areRefined = true;
  for (std::size_t b = 0; b < drawn.meshes.size(); ++b) {
    const Mesh& mesh = drawn.meshes[b];
    if (mesh.dim == 2)
      return false;
    areRefined = areRefined && (mesh.dim == 0 || drawn.halvings[b] > 0);
  }
  return areRefined || haveEnough(drawn.meshes, ranks);
}

std::int64_t refinedDofs(const DrawnScene& drawn, int body)
{
  constexpr int dim = 3;
  const RefinedNumbers& numbers = drawn.numbers[std::size_t(body)];
  return dim * (numbers.numPoints() + numbers.numMiddles());
}

void buildDrawn(DrawnScene& drawn, const SceneSettings& scene, const SceneComponents& components, Ledger& ledger)
{
  const auto timer = timeStage(ledger, Stage::Read);
  std::size_t next = 0;
  drawn.model = buildModel(scene, components, [&](const BodySettings&) {
    const std::size_t b = next++;
    return GivenMesh(std::move(drawn.meshes[b]), {}, std::move(drawn.before[b]));
  });
  drawn.meshes.clear();
}

std::vector<InterfaceMesh> sidesAsDrawn(const DrawnScene& drawn, const SceneSettings& scene)
{
  const auto isHalved = [&](const InterfaceSide& side) {
    const BodySettings& body = scene.bodies[std::size_t(side.body)];
    return !body.isRigid && halvingsOf(body.shape) > 0;
  };
  std::vector<InterfaceMesh> sides;
  for (const InterfaceMesh& interface : drawn.model->interfaces) {
    if (!isHalved(interface.dirichlet()) && !isHalved(interface.neumann()))
      continue;
    const InterfaceMesh& first = interface.firstMesh ? *interface.firstMesh : interface;
    InterfaceMesh side;
    side.name = interface.name;
    side.dim = first.dim;
    side.points = first.points;
    side.facets = first.facets;
    side.measures = first.measures;
    side.endNormals = first.endNormals;
    sides.push_back(std::move(side));
  }
  return sides;
}

std::string needsWhole(const DrawnScene& drawn)
{
  for (const BodyModel& body : drawn.model->bodies) {
    if (body.isRigid)
      continue;
    if (!body.regions.empty() || body.mesh.groups.names.size() > 1)
      return fmt::format("\"{}\" has regions or loads in groups of cells", body.name);
    if (!body.parents.empty())
      return fmt::format("the mesh of \"{}\" is cut where sides do not match", body.name);
    for (const auto& support : body.supports)
      if (!support->params().has("Side") || support->holdsMeanMotion())
        return fmt::format("the support \"{}\" of \"{}\" holds no side", support->params().name(), body.name);
  }
  for (const InterfaceMesh& interface : drawn.model->interfaces)
    if (interface.touchesItself())
      return fmt::format("the sides of \"{}\" belong to one body", interface.name);
  return {};
}

std::vector<Mesh> meshesOf(DrawnScene&& given, const SceneSettings& scene)
{
  DrawnScene drawn = std::move(given); // given back at the end
  std::vector<Mesh> meshes(scene.bodies.size());
  for (std::size_t b = 0; b < drawn.halvings.size(); ++b) {
    const BodySettings& body = scene.bodies[b];
    if (body.isRigid || drawn.halvings[b] < halvingsOf(body.shape))
      continue;
    if (drawn.model)
      meshes[b] = drawn.model->bodies[b].uncut();
    else
      meshes[b] = std::move(drawn.meshes[b]);
  }
  return meshes;
}

} // namespace ndframe

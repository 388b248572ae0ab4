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
  drawn.meshes[body] = refineUniformly(drawn.meshes[body]);
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

void numberNodes(DrawnScene& drawn, int ranks)
{
  for (std::size_t b = 0; b < drawn.meshes.size() && areEnough(drawn, ranks); ++b)
    drawn.numbers.emplace_back(drawn.meshes[b], drawn.halvings[b]);
}

} // namespace

DrawnScene readDrawn(const SceneSettings& scene, const SceneComponents& components, const Model& known, int ranks,
                     Ledger& ledger)
{
  const auto timer = timeStage(ledger, Stage::Read);
  DrawnScene drawn;
  drawn.meshes = readMeshes(scene, components, known, ledger);
  for (const BodySettings& body : scene.bodies)
    drawn.asked.push_back(body.isRigid ? 0 : halvingsOf(body.shape));
  drawn.halvings = drawn.asked;
  refineAlike(drawn, scene);
  for (bool isRefined = true; isRefined && !haveEnough(drawn.meshes, ranks);) {
    isRefined = false;
    for (std::size_t b = 0; b < drawn.meshes.size(); ++b)
      if (drawn.halvings[b] > 1) {
        refine(drawn, b);
        isRefined = true;
      }
  }
  numberNodes(drawn, ranks);
  return drawn;
}

DrawnScene drawnOn(const std::vector<Mesh>& meshes, const SceneSettings& scene, int ranks)
{
  DrawnScene drawn;
  drawn.asked.assign(scene.bodies.size(), 0);
  drawn.halvings = drawn.asked;
  auto next = meshes.begin();
  for (const BodySettings& body : scene.bodies)
    drawn.meshes.push_back(body.isRigid ? Mesh() : *next++);
  numberNodes(drawn, ranks);
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

void buildDrawn(DrawnScene& drawn, const SceneSettings& scene, const SceneComponents& components,
                const std::vector<InterfaceMesh>& earlier, Ledger& ledger)
{
  const auto timer = timeStage(ledger, Stage::Read);
  std::size_t next = 0;
  drawn.model = buildModel(
      scene, components, [&](const BodySettings&) { return GivenMesh(std::move(drawn.meshes[next++])); }, earlier);
  drawn.meshes.clear();
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
    if (scene.bodies[b].isRigid || drawn.halvings[b] < drawn.asked[b])
      continue;
    if (drawn.model)
      meshes[b] = drawn.model->bodies[b].uncut();
    else
      meshes[b] = std::move(drawn.meshes[b]);
  }
  return meshes;
}

} // namespace ndframe

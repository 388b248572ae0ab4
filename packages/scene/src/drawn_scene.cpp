#include <algorithm>
#include <cmath>

#include "ndframe/mesh/refine.hpp"
#include "ndframe/meshing/refined_source.hpp"
#include "ndframe/scene/shared_scene.hpp"
#include "ndframe/scene/stage.hpp"

namespace ndframe
{
namespace
{

bool haveEnough(const std::vector<Mesh>& meshes, int ranks)
{
  std::int64_t vertices = 0;
  for (const Mesh& mesh : meshes)
    vertices += mesh.numPoints();
  return vertices >= fewestVertices(ranks);
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

/// The bodies of an interface whose meshes are drawn: that of the Dirichlet side first.
std::optional<std::array<std::size_t, 2>> drawnBodies(const InterfaceSettings& interface, const SceneSettings& scene)
{
  const auto bodyOf = [&](const std::string& name) {
    return std::size_t(std::find_if(scene.bodies.begin(), scene.bodies.end(),
                                    [&](const BodySettings& body) { return body.name == name && !body.isRigid; }) -
                       scene.bodies.begin());
  };
  const std::size_t a = bodyOf(interface.dirichletBody), b = bodyOf(interface.neumannBody);
  if (a == scene.bodies.size() || b == scene.bodies.size())
    return std::nullopt;
  return std::array{a, b};
}

/// Bodies that touch get as many halvings to come: their sides match in the end if they match now.
void refineAlike(DrawnScene& drawn, const SceneSettings& scene)
{
  for (bool isAlike = false; !isAlike;) {
    isAlike = true;
    for (const InterfaceSettings& interface : scene.interfaces) {
      const auto bodies = drawnBodies(interface, scene);
      if (!bodies || drawn.halvings[(*bodies)[0]] == drawn.halvings[(*bodies)[1]])
        continue;
      const auto [a, b] = *bodies;
      refine(drawn, drawn.halvings[a] > drawn.halvings[b] ? a : b);
      isAlike = false;
    }
  }
}

/// Solids whose sides do not match are refined first: what is cut is not refined.
void refineWhereCut(DrawnScene& drawn, const SceneSettings& scene)
{
  for (const InterfaceSettings& interface : scene.interfaces) {
    const auto bodies = drawnBodies(interface, scene);
    if (!bodies)
      continue;
    const auto [a, b] = *bodies;
    const Mesh &first = drawn.meshes[a], &second = drawn.meshes[b];
    const Side *ours = first.findSide(interface.dirichletSide),
               *theirs = second.findSide(interface.neumannSide.value_or(interface.name));
    if (drawn.halvings[a] == 0 || first.dim != 3 || second.dim != 3 || ours == nullptr || theirs == nullptr ||
        sidesMatch(first, *ours, second, *theirs)) // they have as many halvings to come
      continue;
    for (const std::size_t body : {a, b})
      while (drawn.halvings[body] > 0)
        refine(drawn, body);
  }
  refineAlike(drawn, scene);
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

std::int64_t fewestVertices(int ranks)
{
  return std::int64_t(200) * ranks;
}

std::vector<std::string> contactSides(const SceneSettings& scene, const std::string& body)
{
  std::vector<std::string> sides;
  for (const InterfaceSettings& interface : scene.interfaces) {
    if (interface.dirichletBody == body)
      sides.push_back(interface.dirichletSide);
    if (interface.neumannBody == body)
      sides.push_back(interface.neumannSide.value_or(interface.name));
  }
  return sides;
}

DrawnScene readDrawn(const SceneSettings& scene, const SceneComponents& components, const Model& known, int ranks,
                     Ledger& ledger)
{
  const auto timer = timeStage(ledger, Stage::Read);
  DrawnScene drawn;
  drawn.meshes = readMeshes(scene, components, known, ledger);
  for (const BodySettings& body : scene.bodies)
    drawn.asked.push_back(body.isRigid ? 0 : halvingsOf(body.shape));
  drawn.halvings = drawn.asked;
  drawn.before.resize(drawn.meshes.size());
  refineAlike(drawn, scene);
  refineWhereCut(drawn, scene);
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
  drawn.before.resize(scene.bodies.size());
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
  return areRefined || !drawn.inside.empty() || haveEnough(drawn.meshes, ranks);
}

bool drawsHeldPoints(const DrawnScene& drawn, const SceneSettings& scene)
{
  constexpr double near = 1e-6; // of the diameter, as the support takes a vertex if not told otherwise
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    for (const Params& support : scene.bodies[b].supports) {
      const Mesh& mesh = drawn.meshes[b];
      if (drawn.halvings[b] == 0 || !support.has("At"))
        continue;
      const auto at = support.get<std::vector<double>>("At");
      bool isDrawn = int(at.size()) != mesh.dim; // the support refuses it
      for (int p = 0; p < mesh.numPoints() && !isDrawn; ++p) {
        const double* const x = mesh.point(p);
        isDrawn = std::hypot(x[0] - at[0], x[1] - at[1], x[2] - at[2]) <= near * diameter(mesh);
      }
      if (!isDrawn)
        return false;
    }
  return true;
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
      scene, components,
      [&](const BodySettings&) {
        const std::size_t b = next++;
        GivenMesh given(std::move(drawn.meshes[b]), {}, std::move(drawn.before[b]));
        if (!drawn.inside.empty())
          given.inside = std::move(drawn.inside[b].forces);
        return given;
      },
      earlier);
  drawn.meshes.clear();
  const std::vector<InterfaceMesh>& interfaces = drawn.model->interfaces;
  const bool isCut =
      std::any_of(interfaces.begin(), interfaces.end(), [](const InterfaceMesh& one) { return one.isCut; });
  if (isCut && !drawn.model->isOuter())                   // outer cells that are cut are not shared out
    for (const int body : drawn.model->elasticBodies()) { // the numbers are of meshes that were not
      const auto b = std::size_t(body);
      const BodyModel& whole = drawn.model->bodies[b];
      NDFRAME_ASSERT(whole.parents.empty() || drawn.halvings[b] == 0, "what is cut has been refined");
      drawn.numbers[b] = RefinedNumbers(whole.mesh, drawn.halvings[b]);
    }
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

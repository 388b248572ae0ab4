#include "shared_run.hpp"

#include <algorithm>
#include <utility>

#include "check_model.hpp"
#include "ndframe/algebra/from_rank_zero.hpp"
#include "ndframe/algebra/threads.hpp"
#include "ndframe/run/warnings.hpp"
#include "ndframe/scene/holds.hpp"
#include "ndframe/scene/stage.hpp"

namespace ndframe
{
namespace
{

/// A finer mesh would be whole.
bool certifiesShares(const std::optional<ErrorOptions>& errors)
{
  return !errors || !errors->wants(Estimator::Reference);
}

/// Stars want whole bodies.
bool recoversShares(const RunTools& tools)
{
  const auto& errors = tools.errors;
  return !errors || !errors->recoversStress() || tools.components.recoveries.build(errors->recoveryList)->settles(3);
}

/// Of bodies whose meshes are not all refined, where the deck leaves the choice of the solver: smaller ones may fall
/// back on a factor, which ranks with shares cannot.
constexpr std::int64_t leastDofs = 300'000;

/// What the meshes alone decide.
bool areLarge(const DrawnScene& drawn, const RunTools& tools)
{
  if (!areEnough(drawn, tools.comm.size()))
    return false;
  std::int64_t dofs = 0;
  bool areRefined = true;
  for (std::size_t b = 0; b < drawn.meshes.size(); ++b)
    if (drawn.meshes[b].dim > 0) {
      dofs += refinedDofs(drawn, int(b));
      areRefined = areRefined && drawn.halvings[b] > 0;
    }
  return areRefined || tools.settings.linearSolver == "Multigrid" || dofs >= leastDofs;
}

/// Bodies touch themselves: there two nodes have one place, by which checkpoints of shares know nodes.
bool hasSlits(const Model& model)
{
  return std::any_of(model.interfaces.begin(), model.interfaces.end(),
                     [](const InterfaceMesh& interface) { return interface.touchesItself(); });
}

bool isCut(const Model& model)
{
  return std::any_of(model.bodies.begin(), model.bodies.end(),
                     [](const BodyModel& body) { return !body.isRigid && !body.parents.empty(); });
}

/// Per body the points of its probes.
std::vector<AskedPoints> probedPoints(const RunSettings& settings)
{
  std::vector<AskedPoints> points;
  for (const BodySettings& body : settings.scene.bodies) {
    points.emplace_back();
    for (const ProbeOptions& probe : settings.output.probes)
      if (probe.body == body.name) {
        points.back().tolerance = std::max(points.back().tolerance, probe.tolerance);
        for (std::vector<double>& at : probe.wanted())
          points.back().inCells.push_back(std::move(at));
      }
  }
  return points;
}

bool canBeShared(const DrawnScene& drawn, const RunTools& tools)
{
  const Model& model = *drawn.model;
  const std::vector<int> bodies = model.elasticBodies();
  if (bodies.empty() || !model.solvesWhole || (tools.settings.output.checkpoint && hasSlits(model)) ||
      ((tools.settings.accuracy || model.isOuter()) &&
       isCut(model))) // the next meshes are made from those that are not
    return false;
  std::int64_t together = 0; // those that touch others are solved together
  for (const int body : bodies)
    together += model.touches(body) ? refinedDofs(drawn, body) : 0;
  const auto isForMultigrid = [&](int body) {
    BodyOutline outline = model.outline(body);
    outline.dofs = model.touches(body) ? together : refinedDofs(drawn, body);
    return tools.solver->name(outline, tools.comm.size()) == "Multigrid";
  };
  return std::all_of(bodies.begin(), bodies.end(), isForMultigrid);
}

/// Whether the model is that of an earlier run with these meshes, which could not be shared.
bool isKnown(const Model& model, const SceneSettings& scene)
{
  if (model.recipe.solver.empty())
    return false;
  const std::vector<BodyRecipe>&before = model.recipe.bodies, now = recipeOf(scene).bodies;
  return std::equal(before.begin(), before.end(), now.begin(), now.end(),
                    [](const auto& a, const auto& b) { return a.mesh == b.mesh; });
}

/// Builds and checks a scene; what is told of it, or nothing where it must be whole.
std::optional<ToldScene> tell(DrawnScene& drawn, const std::vector<InterfaceMesh>& earlier, const RunTools& tools)
{
  if (!areLarge(drawn, tools) || !drawsHeldPoints(drawn, tools.settings.scene))
    return std::nullopt;
  const SceneSettings& scene = tools.settings.scene;
  try {
    buildDrawn(drawn, scene, tools.components, earlier, tools.ledger);
  } catch (const InsideNeeded&) {
    return std::nullopt;
  }
  Model& model = *drawn.model;
  offerWhole(model, *tools.coupling, scene.interfaceOperator);
  if (!canBeShared(drawn, tools))
    return std::nullopt;
  checkModel(model, tools, Comm::single());
  const auto timer = timeStage(tools.ledger, Stage::Check);
  ToldScene scenesTold = told(drawn);
  scenesTold.warnings = sceneWarnings(model, tools.settings);
  model.loads.clear(); // what is handed out are meshes
  model.constraints.clear();
  for (BodyModel& body : model.bodies)
    body.nodes = {};
  return scenesTold;
}

/// Interfaces of which only what they were as drawn is known.
std::vector<InterfaceMesh> asFirst(std::vector<InterfaceMesh> sides)
{
  std::vector<InterfaceMesh> interfaces;
  for (InterfaceMesh& side : sides) {
    interfaces.emplace_back();
    interfaces.back().name = side.name;
    interfaces.back().firstMesh = std::make_shared<const InterfaceMesh>(std::move(side));
  }
  return interfaces;
}

/// What the deck alone decides.
bool mayBeShared(const RunTools& tools)
{
  return mayBeShared(tools.settings, tools.comm.size()) && tools.coupling->solvesWhole(3) && recoversShares(tools);
}

/// The scene that rank 0 draws. Collective.
SceneToShare sceneOf(const std::function<DrawnScene()>& draw, const std::vector<InterfaceMesh>& earlier,
                     const RunTools& tools)
{
  constexpr const char* whole = "whole";
  SceneToShare scene;
  const std::string bytes = fromRankZero(tools.comm, [&] {
    scene.drawn = draw();
    const std::optional<ToldScene> found = tell(scene.drawn, earlier, tools);
    return found ? toBytes(*found) : whole;
  });
  if (bytes != whole)
    scene.told = toldSceneFromBytes(bytes);
  return scene;
}

} // namespace

bool mayBeShared(const RunSettings& settings, int ranks)
{
  const OutputOptions& output = settings.output;
  const std::vector<BodySettings>& bodies = settings.scene.bodies;
  return ranks > 1 && certifiesShares(settings.errors) && settings.scene.order == 2 &&
         output.steps == StepsWritten::Final &&
         (settings.linearSolver == "Automatic" || settings.linearSolver == "Multigrid") && !bodies.empty();
}

SceneToShare sceneToShare(const Model& known, const RunTools& tools)
{
  const SceneSettings& scene = tools.settings.scene;
  if (tools.settings.accuracy || !mayBeShared(tools) || isKnown(known, scene))
    return {};
  if (std::optional<DrawnPieces> pieces =
          readPieces(scene, tools.components, probedPoints(tools.settings), tools.comm, tools.ledger))
  {
    SceneToShare toShare = sceneOf([&] { return outerScene(*pieces); }, {}, tools);
    toShare.pieces = std::move(pieces);
    if (toShare.told)
      return toShare;
  }
  return sceneOf([&] { return readDrawn(scene, tools.components, known, tools.comm.size(), tools.ledger); }, {}, tools);
}

SceneToShare sceneToShare(const std::vector<Mesh>& meshes, const std::vector<InterfaceMesh>& earlier,
                          const RunTools& tools)
{
  const bool areSolids = !meshes.empty() && meshes.front().dim == 3;
  if (!areSolids || !mayBeShared(tools))
    return {};
  return sceneOf([&] { return drawnOn(meshes, tools.settings.scene, tools.comm.size()); }, earlier, tools);
}

void takeShares(Model& model, SceneToShare&& scene, const std::vector<InterfaceMesh>& earlier, const RunTools& tools)
{
  const auto timer = timeStage(tools.ledger, Stage::Read);
  const std::vector<InterfaceMesh> drawn = earlier.empty() ? asFirst(std::move(scene.told->sides)) : earlier;
  const SceneSettings& settings = tools.settings.scene;
  const bool withHalo = tools.errors.has_value();
  if (scene.pieces)
    tools.ledger.count("pieces read", scene.pieces->numPieces);
  std::vector<DrawnPart> parts = scene.pieces ? drawnParts(std::move(*scene.pieces), scene.drawn, withHalo, tools.comm)
                                              : drawnParts(std::move(scene.drawn), settings, withHalo, tools.comm);
  ToldScene told = std::move(*scene.told);
  scene = {}; // its memory is needed again
  model = sharedModel(std::move(parts), std::move(told), settings, tools.components, drawn, withHalo, tools.comm,
                      numThreads(tools.comm));
  tools.ledger.count("shared bodies", std::int64_t(model.elasticBodies().size()));
}

bool shareLevel(Model& model, const std::vector<Mesh>& meshes, const RunTools& tools)
{
  SceneToShare scene = sceneToShare(meshes, model.interfaces, tools);
  if (!scene.told)
    return false;
  const std::vector<InterfaceMesh> earlier = std::move(model.interfaces);
  takeShares(model, std::move(scene), earlier, tools);
  return true;
}

} // namespace ndframe

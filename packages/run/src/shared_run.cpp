#include "shared_run.hpp"

#include <algorithm>

#include "check_model.hpp"
#include "ndframe/algebra/from_rank_zero.hpp"
#include "ndframe/algebra/threads.hpp"
#include "ndframe/run/warnings.hpp"
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

bool canBeShared(const DrawnScene& drawn, const RunTools& tools)
{
  const Model& model = *drawn.model;
  const std::vector<int> bodies = model.elasticBodies();
  if (bodies.empty() || !model.solvesWhole || !needsWhole(drawn).empty())
    return false;
  std::int64_t all = 0, together = 0; // those that touch others are solved together
  for (const int body : bodies) {
    const std::int64_t dofs = refinedDofs(drawn, body);
    all += dofs;
    together += model.touches(body) ? dofs : 0;
  }
  const auto isForMultigrid = [&](int body) {
    BodyOutline outline = model.outline(body);
    outline.dofs = model.touches(body) ? together : refinedDofs(drawn, body);
    return tools.solver->name(outline, tools.comm.size()) == "Multigrid";
  };
  const OutputOptions& output = tools.settings.output;
  return std::all_of(bodies.begin(), bodies.end(), isForMultigrid) &&
         (!output.exodus || output.exodusFiles == ExodusFiles::Single ||
          writesPieces(output.exodusFiles, all / model.bodies.front().mesh.dim, tools.comm.size()));
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

/// Reads, builds and checks a scene; what is told of it, or nothing where it must be whole.
std::optional<ToldScene> tell(DrawnScene& drawn, const Model& known, const RunTools& tools)
{
  const SceneSettings& scene = tools.settings.scene;
  drawn = readDrawn(scene, tools.components, known, tools.comm.size(), tools.ledger);
  if (!areLarge(drawn, tools))
    return std::nullopt;
  buildDrawn(drawn, scene, tools.components, tools.ledger);
  Model& model = *drawn.model;
  offerWhole(model, *tools.coupling, scene.interfaceOperator);
  if (!canBeShared(drawn, tools))
    return std::nullopt;
  checkModel(model, tools, Comm::single());
  const auto timer = timeStage(tools.ledger, Stage::Check);
  ToldScene scenesTold = told(model);
  scenesTold.warnings = sceneWarnings(model, tools.settings);
  scenesTold.sides = sidesAsDrawn(drawn, scene);
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

} // namespace

bool mayBeShared(const RunSettings& settings, int ranks)
{
  const OutputOptions& output = settings.output;
  const std::vector<BodySettings>& bodies = settings.scene.bodies;
  return ranks > 1 && certifiesShares(settings.errors) && !settings.accuracy && settings.scene.order == 2 &&
         output.steps == StepsWritten::Final &&
         (settings.linearSolver == "Automatic" || settings.linearSolver == "Multigrid") && !bodies.empty();
}

SceneToShare sceneToShare(const Model& known, const RunTools& tools)
{
  if (!mayBeShared(tools.settings, tools.comm.size()) || !tools.coupling->solvesWhole(3) || !recoversShares(tools) ||
      isKnown(known, tools.settings.scene))
    return {};
  constexpr const char* whole = "whole";
  SceneToShare scene;
  const std::string bytes = fromRankZero(tools.comm, [&] {
    const std::optional<ToldScene> found = tell(scene.drawn, known, tools);
    return found ? toBytes(*found) : whole;
  });
  if (bytes != whole)
    scene.told = toldSceneFromBytes(bytes);
  return scene;
}

void takeShares(Model& model, SceneToShare&& scene, const RunTools& tools)
{
  const auto timer = timeStage(tools.ledger, Stage::Read);
  const std::vector<InterfaceMesh> drawn = asFirst(std::move(scene.told->sides));
  model = sharedModel(std::move(scene.drawn), std::move(*scene.told), tools.settings.scene, tools.components, drawn,
                      tools.errors.has_value(), tools.comm, numThreads(tools.comm));
  tools.ledger.count("shared bodies", std::int64_t(model.elasticBodies().size()));
}

} // namespace ndframe

#include "shared_run.hpp"

#include <algorithm>

#include "ndframe/algebra/threads.hpp"
#include "ndframe/meshing/refined_source.hpp"
#include "ndframe/scene/stage.hpp"

namespace ndframe
{
namespace
{

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

} // namespace

bool mayBeShared(const RunSettings& settings, int ranks)
{
  const OutputOptions& output = settings.output;
  const std::vector<BodySettings>& bodies = settings.scene.bodies;
  return ranks > 1 && !settings.errors && !settings.accuracy && settings.scene.order == 2 &&
         output.steps == StepsWritten::Final &&
         (settings.linearSolver == "Automatic" || settings.linearSolver == "Multigrid") &&
         std::all_of(bodies.begin(), bodies.end(),
                     [](const BodySettings& body) { return body.isRigid || halvingsOf(body.shape) > 0; });
}

DrawnScene drawnToShare(const RunTools& tools)
{
  const SceneSettings& scene = tools.settings.scene;
  if (!mayBeShared(tools.settings, tools.comm.size()) || !tools.coupling->solvesWhole(3))
    return {};
  DrawnScene drawn = readDrawn(scene, tools.components, tools.comm, tools.ledger);
  offerWhole(*drawn.model, *tools.coupling, scene.interfaceOperator);
  return canBeShared(drawn, tools) ? drawn : DrawnScene();
}

void takeShares(Model& model, const DrawnScene& drawn, const RunTools& tools)
{
  const auto timer = timeStage(tools.ledger, Stage::Read);
  model = sharedModel(drawn, tools.settings.scene, tools.components, tools.comm, numThreads(tools.comm));
  tools.ledger.count("shared bodies", std::int64_t(model.elasticBodies().size()));
}

} // namespace ndframe

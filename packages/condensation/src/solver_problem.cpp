#include "ndframe/condensation/condensed_model.hpp"

namespace ndframe
{

SolverProblem solverProblem(const Model& model, int number, const BodySystem& system)
{
  const BodyModel& body = model.bodies[std::size_t(number)];
  SolverProblem problem;
  problem.matrix = &system.K;
  problem.roles = system.dofs.roles;
  problem.kept = system.dofs.keptDofs();
  problem.nearNullSpace = rigidModes(model.rigid[std::size_t(number)], body.nodes, system.dofs.frames);
  problem.nodePoints = nodePoints(body.nodes);
  problem.outline = model.outline(number);
  problem.edgeNodes.ends = edgeEnds(body.nodes);
  const Frames& frames = system.dofs.frames;
  for (int node = 0; node < body.nodes.numNodes() && frames.anyTurned(); ++node)
    if (frames.isTurned(node)) {
      problem.edgeNodes.turned.push_back(node);
      const int size = body.nodes.dim * body.nodes.dim;
      problem.edgeNodes.axes.insert(problem.edgeNodes.axes.end(), frames.axes(node), frames.axes(node) + size);
    }
  return problem;
}

void offerWhole(Model& model, const Coupling& coupling, const Params& representation)
{
  const int dim = model.bodies.front().mesh.dim;
  model.solvesWhole = dim == 3 && coupling.solvesWhole(dim) && representation.get<std::string>("Type") == "Automatic";
  model.recipe.solvesWhole = model.solvesWhole;
}

} // namespace ndframe

#include "ndframe/driver/condensed_model.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "ndframe/base/log.hpp"
#include "ndframe/mesh/partition.hpp"

namespace ndframe
{
namespace
{

/// The interface nodes of one body whose normal displacement is free on both sides.
struct BodyTraceNodes
{
  std::vector<TraceNormal> traces;
  std::vector<int> unknowns;
  std::vector<char> onDirichletSide;
  std::vector<const double*> points;
};

/// Numbers the unknowns and hands each to its two bodies.
std::vector<BodyTraceNodes> numberUnknowns(const Model& model, InterfaceSystem& system)
{
  std::vector<BodyTraceNodes> bodies(model.bodies.size());
  int node = 0;
  for (const auto& interface : model.interfaces)
    for (int i = 0; i < interface.numNodes(); ++i, ++node) {
      if (!model.carriesContact(interface, i))
        continue;
      const auto add = [&](int body, int bodyNode, bool onDirichletSide) {
        auto& b = bodies[std::size_t(body)];
        b.traces.push_back({bodyNode, interface.normals[std::size_t(i)]});
        b.unknowns.push_back(system.size());
        b.onDirichletSide.push_back(onDirichletSide);
        b.points.push_back(interface.point(i));
      };
      add(interface.dirichletBody, interface.dirichletNodes[std::size_t(i)], true);
      add(interface.neumannBody, interface.neumannNodes[std::size_t(i)], false);
      system.nodeOfUnknown.push_back(node);
      system.gap.push_back(interface.gap[std::size_t(i)]);
    }
  return bodies;
}

std::vector<int> ownedNodes(const BodyModel& body, const Comm& comm)
{
  const auto owner = partitionNodes(body.nodes.cellNodes, body.nodes.nodesPerCell, body.nodes.numNodes(), comm.size());
  std::vector<int> owned;
  for (int node = 0; node < body.nodes.numNodes(); ++node)
    if (owner[std::size_t(node)] == comm.rank())
      owned.push_back(node);
  return owned;
}

std::unique_ptr<CondensedBody> factorBody(const BodyModel& body, const RigidBasis& rigid, const BodySystem& system,
                                          const LinearSolver& solver, const Comm& comm, Ledger& ledger)
{
  SolverProblem problem;
  problem.matrix = &system.K;
  problem.roles = system.dofs.roles;
  problem.kept = system.dofs.keptDofs();
  problem.nearNullSpace = rigidModes(rigid, body.nodes, system.dofs.frames);
  problem.nodePoints = body.nodes.points;
  try {
    return solver.factor(problem, comm, ledger);
  } catch (const SingularBody& failure) {
    const int node = failure.dof < 0 ? -1 : failure.dof / body.mesh.dim;
    throw InputError(
        fmt::format("Bodies/{}: its matrix is singular{}: is a part of the mesh not connected to the rest, or an "
                    "element nearly flat? ({})",
                    body.name, node < 0 ? std::string() : " at " + pointText(body.nodes.point(node), body.mesh.dim),
                    failure.what()));
  }
}

BodyTrace makeTrace(const Model& model, int body, const BodyTraceNodes& nodes)
{
  BodyTrace trace;
  trace.body = body;
  trace.unknowns = nodes.unknowns;
  trace.onDirichletSide = nodes.onDirichletSide;
  std::vector<Direction> normals;
  for (const auto& t : nodes.traces)
    normals.push_back(t.normal);
  const auto& rigid = model.rigid[std::size_t(body)];
  const auto& free = model.freeMotions[std::size_t(body)];
  trace.freeMotions = motionTraces(rigid, free, nodes.points, normals);
  if (free.cols() > 0)
    for (const auto& motion : describeMotions(rigid, free))
      trace.motionNames.push_back(fmt::format("{} of {}", motion, model.bodies[std::size_t(body)].name));
  return trace;
}

} // namespace

const BodyTrace* CondensedModel::trace(int body) const
{
  const auto found = std::find_if(interface.bodies.begin(), interface.bodies.end(),
                                  [body](const BodyTrace& trace) { return trace.body == body; });
  return found == interface.bodies.end() ? nullptr : &*found;
}

CondensedModel condense(const Model& model, const LinearSolver& solver, const InterfaceOperator& representation,
                        const Comm& comm, Ledger& ledger, const Log& log)
{
  CondensedModel result;
  const auto traceNodes = numberUnknowns(model, result.interface);
  if (!model.interfaces.empty())
    result.interface.C = std::make_shared<ContactMatrix>(model.interfaces);
  result.systems.reserve(model.bodies.size()); // the factors point to the matrices
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyModel& body = model.bodies[b];
    {
      const auto timer = ledger.time("assemble");
      auto layout = makeDofLayout(body.nodes, model.constraints[b], traceNodes[b].traces);
      result.systems.push_back(assembleBody(body, std::move(layout), ownedNodes(body, comm)));
      result.loads.push_back(result.systems.back().effectiveLoad(comm));
    }
    const BodySystem& system = result.systems.back();
    result.condensed.push_back(factorBody(body, model.rigid[b], system, solver, comm, ledger));
    log.detail(fmt::format("  {}: {}", body.name, result.condensed.back()->description()));
    if (traceNodes[b].traces.empty())
      continue;
    const auto timer = ledger.time("interface");
    BodyTrace trace = makeTrace(model, int(b), traceNodes[b]);
    trace.S = traceOperator(*result.condensed.back(), system.dofs.trace, representation);
    trace.g = traceLoad(*result.condensed.back(), system.dofs.trace, *trace.S, result.loads.back());
    result.interface.bodies.push_back(std::move(trace));
  }
  return result;
}

void reloadCondensed(CondensedModel& condensed, const Model& model, const Comm& comm)
{
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    BodySystem& system = condensed.systems[b];
    system.load = assembleLoad(model.bodies[b], system.dofs.frames);
    condensed.loads[b] = system.effectiveLoad(comm);
  }
  for (auto& trace : condensed.interface.bodies) {
    const auto b = std::size_t(trace.body);
    trace.g = traceLoad(*condensed.condensed[b], condensed.systems[b].dofs.trace, *trace.S, condensed.loads[b]);
  }
}

} // namespace ndframe

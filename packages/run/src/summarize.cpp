#include "ndframe/run/summarize.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/algebra/comm.hpp"
#include "ndframe/condensation/trust.hpp"
#include "ndframe/run/body_results.hpp"
#include "ndframe/run/contact_ends.hpp"
#include "ndframe/run/energy_comparison.hpp"
#include "ndframe/run/warnings.hpp"
#include "probes.hpp"

namespace ndframe
{
namespace
{

void addResultant(std::vector<double>& sum, double force, const Direction& normal)
{
  for (std::size_t k = 0; k < sum.size(); ++k)
    sum[k] += force * normal[k];
}

/// Per interface node of the whole scene, once for all interfaces.
struct NodalContact
{
  InterfaceValues dirichlet, neumann; ///< forces along the normals
  InterfaceValues shares;
};

NodalContact nodalContact(const Run& run)
{
  const InterfaceSystem& system = run.condensed.interface;
  const InterfaceState& state = run.solved.coupling.state;
  return {system.nodalForces(state.forceDirichlet), system.nodalForces(state.forceNeumann), system.shares()};
}

/// Forces of one interface: nodal forces C Lambda along the node normals.
void addForces(InterfaceSummary& summary, const InterfaceMesh& interface, const NodalContact& nodal,
               std::size_t firstNode)
{
  summary.forceOnDirichlet.assign(std::size_t(interface.dim), 0.0);
  summary.forceOnNeumann.assign(std::size_t(interface.dim), 0.0);
  for (std::size_t i = 0; i < std::size_t(interface.numNodes()); ++i) {
    addResultant(summary.forceOnDirichlet, nodal.dirichlet[firstNode + i], interface.normals[i]);
    addResultant(summary.forceOnNeumann, -nodal.neumann[firstNode + i], interface.normals[i]);
    summary.contactForce -= nodal.dirichlet[firstNode + i];
  }
}

/// Length or area of the contact: every closed node counts with the integral of its function, so that an end inside a
/// facet is seen.
double closedMeasure(const Run& run, const Vector& share, std::size_t firstNode, std::size_t numNodes)
{
  double measure = 0.0;
  for (std::size_t i = firstNode; i < firstNode + numNodes; ++i)
    measure += run.solved.contact[i].closed ? share[i] : 0.0;
  return measure;
}

/// The corners of the box around the closed nodes.
std::vector<std::vector<double>> boxCorners(const InterfaceMesh& interface, const Run& run, std::size_t firstNode)
{
  std::vector<double> low, high;
  for (int i = 0; i < interface.numNodes(); ++i) {
    if (!run.solved.contact[firstNode + std::size_t(i)].closed)
      continue;
    const std::vector<double> point(interface.point(i), interface.point(i) + interface.dim);
    if (low.empty())
      low = high = point;
    for (std::size_t k = 0; k < point.size(); ++k) {
      low[k] = std::min(low[k], point[k]);
      high[k] = std::max(high[k], point[k]);
    }
  }
  return low.empty() ? std::vector<std::vector<double>>() : std::vector{low, high};
}

/// The two closed nodes that are farthest apart (one if there is only one).
std::vector<std::vector<double>> endPoints(const InterfaceMesh& interface, const Run& run, std::size_t firstNode)
{
  const auto distance = [&](int a, int b) {
    double squared = 0.0;
    for (int k = 0; k < interface.dim; ++k)
      squared += std::pow(interface.point(a)[k] - interface.point(b)[k], 2);
    return squared;
  };
  // The node farthest from any closed node is an end; the one farthest from it is the other.
  const auto farthest = [&](int from) {
    int best = -1;
    for (int i = 0; i < interface.numNodes(); ++i)
      if (run.solved.contact[firstNode + std::size_t(i)].closed &&
          (best < 0 || distance(from, i) > distance(from, best)))
        best = i;
    return best;
  };
  const int any = farthest(0);
  if (any < 0)
    return {};
  const int first = farthest(any), second = farthest(first);
  std::vector<std::vector<double>> ends;
  for (const int end : {std::min(first, second), std::max(first, second)})
    ends.emplace_back(interface.point(end), interface.point(end) + interface.dim);
  std::sort(ends.begin(), ends.end());
  return ends;
}

void completeInterfaces(RunSummary& all, const Run& run)
{
  if (run.model.interfaces.empty())
    return;
  const NodalContact nodal = nodalContact(run);
  std::size_t firstNode = 0;
  for (std::size_t i = 0; i < run.model.interfaces.size(); ++i) {
    const auto& interface = run.model.interfaces[i];
    auto& summary = all.interfaces[i];
    addForces(summary, interface, nodal, firstNode);
    summary.contactMeasure = closedMeasure(run, nodal.shares, firstNode, std::size_t(interface.numNodes()));
    summary.endPoints = summary.isArea ? boxCorners(interface, run, firstNode) : endPoints(interface, run, firstNode);
    summary.endBrackets = endBrackets(interface, run.solved.contact.data() + firstNode);
    for (int k = 0; k < interface.numNodes(); ++k) {
      const ContactNode& node = run.solved.contact[firstNode + std::size_t(k)];
      summary.closedNodes += node.closed;
      summary.largestPressure = std::max(summary.largestPressure, node.pressure);
      summary.largestPenetration = std::max(summary.largestPenetration, -node.gap);
    }
    firstNode += std::size_t(interface.numNodes());
  }
}

void completeCoupling(RunSummary& summary, const CouplingResult& result)
{
  auto& coupling = *summary.coupling;
  if (!result.type.empty())
    coupling.type = result.type;
  coupling.sweeps = int(result.history.size());
  coupling.converged = result.converged;
  coupling.reason = result.reason;
  for (const auto& record : result.history)
    coupling.history.push_back({record.sweep, record.epsTau, record.theta, record.statusChanges, record.statusPasses,
                                record.closed, record.open, record.forceDirichlet, record.forceNeumann,
                                record.penetration, record.note});
}

void addWarnings(RunSummary& summary, const std::vector<Warning>& warnings)
{
  for (const auto& warning : warnings)
    summary.warnings.push_back(warningSummary(warning));
}

} // namespace

std::string versionText()
{
  return NDFRAME_VERSION;
}

RunSummary outlineSummary(const Model& model, const RunSettings& settings, const LinearSolver& solver, int ranks)
{
  RunSummary summary;
  summary.version = versionText();
  summary.build = buildInfo();
  summary.title = settings.title;
  summary.deckJson = toJson(settings.deck);
  summary.ranks = ranks;
  summary.perUnitThickness = model.bodies.front().mesh.dim == 2;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    BodySummary body;
    body.name = model.bodies[b].name;
    body.dofs = model.bodies[b].isRigid ? 0 : model.bodies[b].totalDofs();
    body.elements = model.bodies[b].totalCells();
    body.order = model.bodies[b].nodes.order;
    body.solver = model.bodies[b].isRigid ? "-" : solver.name(model.outline(int(b)), ranks);
    body.heldBy = model.told ? model.told->heldBy[b] : heldBy(model, int(b));
    for (const auto& support : model.bodies[b].supports)
      body.supports.push_back({support->params().name(), support->description(), {}, {}, {}});
    summary.bodies.push_back(std::move(body));
  }
  for (const auto& interface : model.interfaces) {
    InterfaceSummary outline;
    outline.name = interface.name;
    outline.isArea = interface.dim == 3;
    outline.dirichletBody = model.bodies[std::size_t(interface.dirichlet().body)].name;
    outline.neumannBody = model.bodies[std::size_t(interface.neumann().body)].name;
    outline.nodes = interface.numNodes();
    summary.interfaces.push_back(std::move(outline));
  }
  summary.probes = outlineProbes(model, settings.output.probes);
  if (!model.interfaces.empty()) {
    summary.coupling.emplace();
    summary.coupling->type = settings.coupling;
  }
  return summary;
}

std::vector<RoleSummary> rolesOf(const Run& run)
{
  return run.summary.coupling ? run.summary.coupling->roles : std::vector<RoleSummary>();
}

void nameSides(RunSummary& summary, const Model& model)
{
  for (std::size_t i = 0; i < model.interfaces.size(); ++i) {
    const auto& interface = model.interfaces[i];
    summary.interfaces[i].dirichletBody = model.bodies[std::size_t(interface.dirichlet().body)].name;
    summary.interfaces[i].neumannBody = model.bodies[std::size_t(interface.neumann().body)].name;
  }
}

RunSummary completeSummary(const Run& run, const RunSettings& settings, const Comm& comm)
{
  RunSummary summary = run.summary;
  if (summary.coupling)
    completeCoupling(summary, run.solved.coupling);
  summary.solved = !run.solved.states.empty();
  addWarnings(summary, sceneWarnings(run.model, settings));
  if (!summary.solved)
    return summary;
  completeBodies(summary, run, settings.strainLimit, comm);
  completeInterfaces(summary, run);
  summary.probes = sampleProbes(run, settings.output.probes, comm);
  addWarnings(summary, answerWarnings(run, summary, settings, comm));
  summary.residuals =
      residuals(run.model, run.condensed, run.solved.coupling.state, run.solved.fields, run.solved.contact, comm);
  summary.residuals.allowedInContact = run.solved.coupling.contactTolerance;
  if (run.certificate) {
    summary.errors = run.certificate->summary;
    summary.errors->energyBracket = summarizeEnergy(run, 0.5 * summary.energy);
  }
  checkExpectations(summary, settings);
  return summary;
}

void copyLedger(RunSummary& summary, Ledger& ledger, double startSeconds)
{
  countReductions(ledger);
  summary.counts = ledger.counts();
  summary.stages.clear();
  for (const auto& stage : ledger.stages())
    summary.stages.push_back({stage.name, stage.seconds, stage.peakBytes});
  summary.totalSeconds = wallSeconds() - startSeconds;
  summary.peakBytes = peakMemory();
}

} // namespace ndframe

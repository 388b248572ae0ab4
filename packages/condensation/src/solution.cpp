#include "ndframe/condensation/solution.hpp"

#include <algorithm>

#include "ndframe/algebra/threads.hpp"
#include "ndframe/scene/holds.hpp"
#include "ndframe/scene/stage.hpp"

namespace ndframe
{
namespace
{

/// Kept values of a body in each state, n_c x states.
DenseMatrix keptMatrix(const BodyTrace& trace, const std::vector<InterfaceState>& states)
{
  DenseMatrix kept(trace.map.size(), int(states.size()));
  for (int s = 0; s < kept.cols(); ++s) {
    const InterfaceState& state = states[std::size_t(s)];
    const Vector& uNeumann = state.motionsNeumann.empty() ? state.uNeumann : state.strainedNeumann;
    Vector normal;
    for (std::size_t k = 0; k < trace.unknowns.size(); ++k)
      normal.push_back(
          (trace.roles[k] == ContactRole::Dirichlet ? state.uDirichlet : uNeumann)[std::size_t(trace.unknowns[k])]);
    const Vector values = trace.map.keptValues(normal);
    std::copy(values.begin(), values.end(), kept.col(s));
  }
  return kept;
}

/// A body's amplitudes among those of all Neumann bodies; none when the coupling did not find them.
Vector amplitudesOf(int body, const InterfaceSystem& system, const InterfaceState& state)
{
  auto first = state.motionsNeumann.begin();
  for (const auto& trace : system.bodies) {
    if (system.roleOf(trace) == ContactRole::Dirichlet || state.motionsNeumann.empty())
      continue;
    const auto last = first + trace.freeMotions.cols();
    if (trace.body == body)
      return {first, last};
    first = last;
  }
  return {};
}

/// Adds the motions with these amplitudes to a field in the nodes' own axes; supports hold what they hold exactly.
void addMotions(Vector& u, const Vector& amplitudes, const Model& model, std::size_t b, const DofLayout& dofs)
{
  const Vector motion = multiply(rigidModes(model.rigid[b], model.bodies[b].nodes, dofs.frames),
                                 multiply(model.freeMotions[b], amplitudes));
  for (std::size_t i = 0; i < u.size(); ++i)
    if (dofs.roles[i] != DofRole::Fixed)
      u[i] += motion[i];
}

/// The displacements of a body that no rank has as a whole and that touches nothing, at the nodes of the part.
Vector solvedAlone(const CondensedBody& body, const SparseField& load, const BodyShare& share)
{
  const WholeSolver* const solver = wholeSolver(body);
  const auto system = solver->join({solver}, {});
  system->follow({}, {}, 0.0);
  Vector none;
  system->solve({&load}, none, system->tolerance());
  const NodalField own = std::move(std::move(*system).takeFields().front());
  return share.spread(Vector(own.begin(), own.end()), own.width());
}

/// A body's displacements but for prescribed ones, n x states: those that the coupling found, or recovered from the
/// trace.
DenseMatrix solutions(const CondensedModel& condensed, int body, const std::vector<InterfaceState>& states)
{
  const auto b = std::size_t(body);
  const BodyTrace* trace = condensed.trace(body);
  const int steps = int(states.size());
  DenseMatrix u(int(condensed.systems[b].dofs.roles.size()), steps);
  if (trace != nullptr && !states.front().fields.empty()) {
    const auto place = std::size_t(trace - condensed.interface.bodies.data());
    for (int s = 0; s < steps; ++s)
      std::copy_n(states[std::size_t(s)].fields[place].begin(), u.rows(), u.col(s));
    return u;
  }
  if (condensed.systems[b].share) { // it touches nothing: one state
    const Vector alone = solvedAlone(*condensed.condensed[b], condensed.loads[b], *condensed.systems[b].share);
    for (int s = 0; s < steps; ++s)
      std::copy(alone.begin(), alone.end(), u.col(s));
    return u;
  }
  const NodalField load = condensed.loads[b].all();
  for (int s = 0; s < steps; ++s)
    std::copy(load.begin(), load.end(), u.col(s));
  return condensed.condensed[b]->expand(u, trace == nullptr ? DenseMatrix(0, steps) : keptMatrix(*trace, states));
}

double normalDisplacement(const Vector& displacement, int node, const Direction& normal, int dim)
{
  double u = 0.0;
  for (int k = 0; k < dim; ++k)
    u += displacement[std::size_t(node) * std::size_t(dim) + std::size_t(k)] * normal[std::size_t(k)];
  return u;
}

/// The pressure of a node is its force over its share of the side, the integral of its function: never tension, zero
/// where contact is open, and with the resultant of the forces, which the nodal values C^-1 r are not. The same of the
/// functions of means, where contact is asked of these.
void addPressures(std::vector<ContactNode>& nodes, const InterfaceSystem& system, const UnknownValues& force)
{
  const InterfaceValues share = system.shares();
  if (system.mortar) {
    Vector pressure = system.mortar->forcesOf(force);
    const Vector shares = system.mortar->forcesOf(system.atUnknowns(share));
    for (std::size_t j = 0; j < pressure.size(); ++j)
      pressure[j] = shares[j] > 0.0 ? std::max(0.0, -pressure[j] / shares[j]) : 0.0;
    pressure = system.mortar->valuesAtUnknowns(pressure);
    for (std::size_t k = 0; k < pressure.size(); ++k)
      nodes[std::size_t(system.nodeOfUnknown[k])].pressure = std::max(0.0, pressure[k]);
    return;
  }
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (nodes[i].closed) {
      NDFRAME_ASSERT(share[i] > 0.0, "every node of an interface has a share of it");
      nodes[i].pressure = std::max(0.0, -nodes[i].nodalForce / share[i]);
    }
}

/// What contact is asked of at the unknowns: gaps, or coefficients of them.
void addConditions(std::vector<ContactNode>& nodes, const InterfaceSystem& system)
{
  Vector jumps;
  for (ContactNode& node : nodes) {
    jumps.push_back(node.uDirichlet - node.uNeumann);
    node.condition = node.gap;
  }
  if (!system.basis)
    return;
  jumps = system.basis->coefficients(jumps);
  for (std::size_t k = 0; k < system.nodeOfUnknown.size(); ++k) {
    const auto node = std::size_t(system.nodeOfUnknown[k]);
    nodes[node].condition = system.gap[k] - jumps[node];
  }
}

} // namespace

std::vector<BodyFields> recoverFields(const Model& model, const CondensedModel& condensed,
                                      const std::vector<InterfaceState>& states, const Comm& comm, Ledger& ledger)
{
  const auto timer = timeStage(ledger, Stage::Recover);
  std::vector<BodyFields> all(model.bodies.size());
  const int steps = int(states.size());
  runLargestFirst(model.numDofs(), condensed.threads, [&](int body) {
    const auto b = std::size_t(body);
    const BodySystem& system = condensed.systems[b];
    const DenseMatrix u = solutions(condensed, body, states);
    for (int s = 0; s < steps; ++s) {
      Vector full = u.column(s);
      system.dofs.addPrescribed(full);
      Vector moved = full;
      if (const Vector amplitudes = amplitudesOf(int(b), condensed.interface, states[std::size_t(s)]);
          !amplitudes.empty())
        addMotions(moved, amplitudes, model, b, system.dofs);
      all[b].displacement.push_back(system.dofs.frames.toGlobal(moved));
      all[b].u.push_back(atNodes(std::move(full), system.K.dim));
    }
    all[b].forces = atNodes(system.forcesOf(all[b].u.back(), comm), system.K.dim);
  });
  for (std::size_t s = 0; s < states.size(); ++s) {
    std::vector<NodalField*> ofState;
    for (BodyFields& body : all)
      ofState.push_back(&body.displacement[s]);
    removeMeanMotions(model, std::move(ofState), comm);
  }
  return all;
}

std::vector<ContactNode> contactNodes(const Model& model, const CondensedModel& condensed, const InterfaceState& state,
                                      const std::vector<BodyFields>& fields, std::size_t step)
{
  std::vector<ContactNode> all;
  for (std::size_t number = 0; number < model.interfaces.size(); ++number) {
    const InterfaceMesh& interface = model.interfaces[number];
    for (int i = 0; i < interface.numNodes(); ++i) {
      const auto node = all.size();
      const Direction& normal = interface.normals[std::size_t(i)];
      ContactNode entry;
      entry.interface = int(number);
      std::copy_n(interface.point(i), interface.dim, entry.point.begin());
      entry.uDirichlet = normalDisplacement(fields[std::size_t(interface.dirichlet().body)].displacement[step],
                                            interface.dirichlet().nodes[std::size_t(i)], normal, interface.dim);
      entry.uNeumann = normalDisplacement(fields[std::size_t(interface.neumann().body)].displacement[step],
                                          interface.neumann().nodes[std::size_t(i)], normal, interface.dim);
      entry.gap = interface.gap[std::size_t(i)] - (entry.uDirichlet - entry.uNeumann);
      entry.tractionDirichlet = state.tractionDirichlet[node];
      entry.tractionNeumann = state.tractionNeumann[node];
      all.push_back(entry);
    }
  }
  addConditions(all, condensed.interface);
  for (std::size_t k = 0; k < condensed.interface.nodeOfUnknown.size(); ++k) {
    ContactNode& entry = all[std::size_t(condensed.interface.nodeOfUnknown[k])];
    entry.nodalForce = state.forceDirichlet[k];
    entry.closed = state.closed[k] != 0;
  }
  if (!all.empty())
    addPressures(all, condensed.interface, state.forceDirichlet);
  return all;
}

} // namespace ndframe

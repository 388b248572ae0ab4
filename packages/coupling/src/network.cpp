#include "network.hpp"

#include <algorithm>

#include "ndframe/base/diagnostics.hpp"
#include "sweep.hpp"

namespace ndframe
{
namespace
{

/// The entries of one body in the rows of its unknowns.
void addBody(Network& network, const BodyTrace& body)
{
  const int first = network.offsets.back();
  const auto row = [&](int unknown, ContactRole role) -> SparseRow& {
    return (role == ContactRole::Dirichlet ? network.dirichlet : network.neumann)[std::size_t(unknown)];
  };
  for (std::size_t k = 0; k < body.unknowns.size(); ++k)
    row(body.unknowns[k], body.roles[k]).emplace_back(first + int(k), 1.0);
  for (const DependentUnknown& dependent : body.dependents) {
    SparseRow& entries = row(dependent.unknown, dependent.role);
    for (const auto& [k, share] : dependent.row)
      entries.emplace_back(first + k, share);
    (dependent.role == ContactRole::Dirichlet ? network.dirichletOffset
                                              : network.neumannOffset)[std::size_t(dependent.unknown)] +=
        dependent.offset;
  }
  network.bodies.push_back(&body);
  network.offsets.push_back(first + int(body.unknowns.size()));
}

/// The conditions W (D - N) v <= W bound.
void takeMeans(Network& network, const MortarSpace& mortar)
{
  network.jump = product(mortar.means(), network.jump, network.size());
  network.bound = mortar.meansOf(network.bound);
  network.hasMeans = true;
}

} // namespace

Network unloadedNetworkOf(const InterfaceSystem& system)
{
  const auto size = std::size_t(system.size());
  Network network;
  network.offsets = {0};
  network.dirichlet.resize(size);
  network.neumann.resize(size);
  network.dirichletOffset.assign(size, 0.0);
  network.neumannOffset.assign(size, 0.0);
  for (const BodyTrace& body : system.bodies)
    addBody(network, body);
  for (std::size_t i = 0; i < size; ++i) {
    SparseRow row = network.dirichlet[i];
    for (const auto& [entry, value] : network.neumann[i])
      row.emplace_back(entry, -value);
    network.jump.push_back(std::move(row));
    network.bound.push_back(system.gap[i] + system.obstacle[i] - network.dirichletOffset[i] + network.neumannOffset[i]);
  }
  if (system.mortar)
    takeMeans(network, *system.mortar);
  return network;
}

Network networkOf(const InterfaceSystem& system)
{
  Network network = unloadedNetworkOf(system);
  for (const BodyTrace* body : network.bodies)
    network.g.insert(network.g.end(), body->g.begin(), body->g.end());
  return network;
}

Vector rowValues(const std::vector<SparseRow>& rows, const Vector& offset, const Vector& v)
{
  Vector values = offset;
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const auto& [entry, value] : rows[i])
      values[i] += value * v[std::size_t(entry)];
  return values;
}

std::vector<std::string> motionNames(const Network& network)
{
  std::vector<std::string> names;
  for (const BodyTrace* body : network.bodies)
    names.insert(names.end(), body->motionNames.begin(), body->motionNames.end());
  return names;
}

std::vector<int> tightestFirst(const Network& network, const std::vector<char>& closed)
{
  std::vector<int> chosen;
  for (std::size_t i = 0; i < closed.size(); ++i)
    if (closed[i])
      chosen.push_back(int(i));
  std::stable_sort(chosen.begin(), chosen.end(),
                   [&](int a, int b) { return network.bound[std::size_t(a)] < network.bound[std::size_t(b)]; });
  return chosen;
}

Vector conditionForces(const InterfaceSystem& system, const InterfaceValues& traction)
{
  const UnknownValues force = system.force(traction);
  return system.mortar ? system.mortar->forcesOf(force) : force.whole();
}

void setDisplacement(const Network& network, const Vector& v, StatusPass& pass)
{
  pass.u = rowValues(network.jump, Vector(network.jump.size(), 0.0), v);
  pass.displacement = largestEntry(v);
  pass.load = largestEntry(network.g);
}

UnilateralState findStatuses(StatusSystem& problem, const Network& network, const InterfaceSystem& system,
                             const CouplingStart& start, Ledger& ledger)
{
  std::vector<char> first = firstStatuses(system, floats(system), start);
  if (system.mortar)
    first = system.mortar->statusesOf(first);
  return findStatuses(problem, std::vector<char>(network.bound.size(), 1), network.bound, std::move(first), ledger,
                      passesOf(start.sweeps));
}

InterfaceState stateAt(const Network& network, const InterfaceSystem& system, const Vector& v,
                       const UnilateralState& status)
{
  InterfaceState state;
  state.uDirichlet = ofUnknowns(rowValues(network.dirichlet, network.dirichletOffset, v));
  state.uNeumann = system.withObstacles(ofUnknowns(rowValues(network.neumann, network.neumannOffset, v)));
  state.closed = system.mortar ? system.mortar->statusesAtUnknowns(status.closed) : status.closed;
  state.forceDirichlet = ofUnknowns(system.mortar ? system.mortar->forcesAtUnknowns(status.force) : status.force);
  state.forceNeumann = state.forceDirichlet;
  state.tractionDirichlet = state.tractionNeumann = system.traction(state.forceDirichlet);
  return state;
}

void needStoredOperators(const InterfaceSystem& system, const std::string& coupling)
{
  for (const BodyTrace& body : system.bodies)
    if (body.S->dense() == nullptr)
      throw NotConverged(coupling + " needs stored interface operators: choose Interface Operator/Type = Condensed");
}

bool floats(const InterfaceSystem& system)
{
  return std::any_of(system.bodies.begin(), system.bodies.end(),
                     [](const BodyTrace& body) { return body.freeMotions.cols() > 0; });
}

bool hasDependents(const InterfaceSystem& system)
{
  return std::any_of(system.bodies.begin(), system.bodies.end(),
                     [](const BodyTrace& body) { return !body.dependents.empty(); });
}

} // namespace ndframe

#include "intermediate_fields.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/algebra/own_field.hpp"
#include "ndframe/algebra/shared_values.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/subdomain/neumann_problem.hpp"
#include "near_field.hpp"

namespace ndframe
{
namespace
{

/// Forces that differ by less than this, relative to the largest, are the same.
constexpr double sameForce = 1e-13;

bool isFixed(const BodySystem& system, std::size_t dof)
{
  return system.dofs.roles[dof] == DofRole::Fixed;
}

/// True when two sets of nodal forces differ only where supports take the difference.
bool areSame(const BodySystem& system, const Vector& a, const Vector& b, const Comm& comm)
{
  const NodalField first = system.dofs.frames.toLocal(a), second = system.dofs.frames.toLocal(b);
  double difference = 0.0, scale = system.load.largest();
  for (std::size_t i = 0; i < first.size(); ++i) {
    scale = std::max(scale, std::abs(first[i]));
    if (!isFixed(system, i))
      difference = std::max(difference, std::abs(first[i] - second[i]));
  }
  Vector largest{difference, scale};
  if (system.share)
    takeLargest(largest, comm);
  return largest[0] <= sameForce * largest[1];
}

/// Normal displacements of a field at a body's trace.
Vector traceValues(const BodySystem& system, const BodyTrace& trace, const Vector& solved)
{
  const NodalField own = system.dofs.frames.toLocal(solved);
  Vector kept;
  for (const int dof : trace.map.dofs())
    kept.push_back(own[std::size_t(dof)]);
  return trace.map.values(kept);
}

/// S u_N = g under the loads of one field; held entries keep the values of `start`.
Vector solveTrace(const BodyTrace& trace, const RestrictedInverse& inverse, const std::vector<char>& isFree,
                  const Vector& g, const Vector& start)
{
  Vector held = start;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (isFree[i])
      held[i] = 0.0;
  Vector right = trace.S->apply(held);
  for (std::size_t i = 0; i < right.size(); ++i)
    right[i] = g[i] - right[i];
  Vector u = inverse.solve(right);
  for (std::size_t i = 0; i < u.size(); ++i)
    u[i] += held[i];
  return u;
}

/// Effective load plus contact forces, in the nodes' own axes.
NodalField loaded(const BodySystem& system, const SparseField& effective, const Vector& force)
{
  Vector load = system.dofs.frames.toLocal(force).whole();
  effective.addTo(load);
  return atNodes(std::move(load), effective.width());
}

/// g = reduced load plus contact forces. Forces that act on kept dofs only need no back-solve: true of every straight
/// interface, where the nodes' normals are the facets'.
Vector traceLoadUnder(const CondensedModel& condensed, int body, const Vector& load)
{
  const auto b = std::size_t(body);
  const BodySystem& system = condensed.systems[b];
  const BodyTrace& trace = *condensed.trace(body);
  double inside = 0.0, largest = 0.0;
  Vector force = load;
  condensed.loads[b].addTo(force, -1.0);
  for (std::size_t i = 0; i < force.size(); ++i) {
    largest = std::max(largest, std::abs(force[i]));
    if (system.dofs.roles[i] == DofRole::Interior)
      inside = std::max(inside, std::abs(force[i]));
  }
  if (inside > sameForce * largest)
    return traceLoad(*condensed.condensed[b], trace.map, *trace.S, load);
  Vector kept;
  for (const int dof : trace.map.dofs())
    kept.push_back(force[std::size_t(dof)]);
  Vector g = trace.map.forces(kept);
  for (std::size_t k = 0; k < g.size(); ++k)
    g[k] += trace.g[k];
  return g;
}

/// By iterations, from values that all ranks have.
Vector solveAll(const BodySystem& system, const WholeSolver& whole, const NodalField& load, Vector start,
                const Comm& comm)
{
  const IndexMap& nodes = system.K.nodes;
  return onEveryRank(
      whole.solveFree(ownPart(load, nodes), ownPart(atNodes(std::move(start), load.width()), nodes), Exactness::Rough),
      comm);
}

/// The unknown fields by iterations on the whole body, from those that are there. False where it gives up.
bool solveWhole(const CondensedModel& condensed, int body, const std::vector<NodalField>& forces,
                const std::vector<std::size_t>& unknown, const FieldNeed& need, std::vector<NodalField>& fields)
{
  const auto b = std::size_t(body);
  const BodySystem& system = condensed.systems[b];
  const WholeSolver& whole = *condensed.trace(body)->whole;
  try {
    for (const std::size_t f : unknown) {
      Vector u = system.dofs.frames.toLocal(fields[f]).whole();
      system.dofs.addPrescribed(u, -1.0);
      const NodalField load = loaded(system, condensed.loads[b], forces[f]);
      const auto near =
          need.isNear ? nearField(system, load.whole(), u, need.enough, need.comm) : std::optional<Vector>();
      u = near ? *near : solveAll(system, whole, load, std::move(u), need.comm);
      system.dofs.addPrescribed(u);
      fields[f] = system.dofs.frames.toGlobal(u);
    }
    return true;
  } catch (const NotConverged&) {
    if (!whole.givesUp())
      throw;
    return false;
  }
}

/// By iterations on the shares of all ranks, or with the diagonal alone where these do not go on. Values at the nodes
/// of the part, prescribed ones among them.
Vector solvePart(const BodySystem& system, const WholeSolver& whole, const Vector& load, const Vector& start,
                 const FieldNeed& need)
{
  const BlockMatrix& K = system.K;
  try {
    const NodalField u = whole.solveFree(system.share->own(load, K.dim, K.nodes),
                                         system.share->own(start, K.dim, K.nodes), Exactness::Rough);
    return system.share->spread({u.begin(), u.end()}, K.dim);
  } catch (const NotConverged&) {
  } catch (const SingularBody&) {
  }
  return fieldOfPart(system, load, start, need.enough, need.comm);
}

/// The unknown field of a body that ranks have parts of.
NodalField partField(const BodySystem& system, const WholeSolver& whole, const NodalField& force,
                     const NodalField& start, const FieldNeed& need)
{
  Vector load = system.dofs.frames.toLocal(force).whole();
  const NodalField given = system.load.all(), local = system.dofs.frames.toLocal(start);
  for (std::size_t i = 0; i < load.size(); ++i)
    load[i] += given[i];
  std::optional<Vector> u;
  if (need.isNear)
    u = nearField(system, load, local.whole(), need.enough, need.comm);
  return system.dofs.frames.toGlobal(u ? *u : solvePart(system, whole, load, local.whole(), need));
}

/// The body's displacements for several right-hand sides at once.
std::vector<NodalField> expandAll(const BodySystem& system, const CondensedBody& body, const DenseMatrix& loads,
                                  const DenseMatrix& kept)
{
  const DenseMatrix u = body.expand(loads, kept);
  std::vector<NodalField> fields;
  for (int f = 0; f < u.cols(); ++f) {
    Vector full = u.column(f);
    system.dofs.addPrescribed(full);
    fields.push_back(system.dofs.frames.toGlobal(full));
  }
  return fields;
}

} // namespace

Vector solvedForces(const CondensedModel& condensed, int body, const InterfaceState& state)
{
  const BodySystem& system = condensed.systems[std::size_t(body)];
  const BodyTrace& trace = *condensed.trace(body);
  Vector force(system.load.size(), 0.0);
  const Vector kept = trace.map.keptForces(trace.forces(state.forceDirichlet, state.forceNeumann));
  for (std::size_t k = 0; k < kept.size(); ++k)
    force[std::size_t(trace.map.dofs()[k])] += kept[k];
  return system.dofs.frames.toGlobal(force).whole();
}

std::vector<NodalField> intermediateFields(const Model& model, const CondensedModel& condensed, int body,
                                           const std::vector<NodalField>& forces, const Vector& known,
                                           const NodalField& solved, const FieldNeed& need)
{
  const auto b = std::size_t(body);
  const BodySystem& system = condensed.systems[b];
  const BodyTrace& trace = *condensed.trace(body);
  std::vector<NodalField> fields(forces.size(), solved);
  std::vector<std::size_t> unknown;
  for (std::size_t f = 0; f < forces.size(); ++f)
    if (!areSame(system, forces[f], known, need.comm))
      unknown.push_back(f);
  if (unknown.empty())
    return fields;
  if (system.share) {
    for (const std::size_t f : unknown)
      fields[f] = partField(system, *trace.whole, forces[f], fields[f], need);
    return fields;
  }
  if (trace.isSolvedWhole() && solveWhole(condensed, body, forces, unknown, need, fields))
    return fields;
  const Vector start = traceValues(system, trace, solved);
  const auto isFree = freeWhenHeld(trace.freeMotions);
  const auto inverse = trace.S->inverseOn(isFree, 0.0);
  DenseMatrix loads(model.bodies[b].numDofs(), int(unknown.size())), kept(int(start.size()), int(unknown.size()));
  for (std::size_t j = 0; j < unknown.size(); ++j) {
    const NodalField load = loaded(system, condensed.loads[b], forces[unknown[j]]);
    const Vector g = traceLoadUnder(condensed, body, load);
    const Vector values = trace.map.keptValues(solveTrace(trace, *inverse, isFree, g, start));
    std::copy(load.begin(), load.end(), loads.col(int(j)));
    std::copy(values.begin(), values.end(), kept.col(int(j)));
  }
  const auto expanded = expandAll(system, *condensed.condensed[b], loads, kept);
  for (std::size_t j = 0; j < unknown.size(); ++j)
    fields[unknown[j]] = expanded[j];
  return fields;
}

} // namespace ndframe

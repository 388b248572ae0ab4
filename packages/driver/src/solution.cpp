#include "ndframe/driver/solution.hpp"

#include <algorithm>
#include <cmath>

namespace ndframe
{
namespace
{

/// Kept values of a body in each state, n_c x states.
DenseMatrix keptMatrix(const BodyTrace& trace, const std::vector<TraceDof>& dofs,
                       const std::vector<InterfaceState>& states)
{
  DenseMatrix kept(int(dofs.size()), int(states.size()));
  for (int s = 0; s < kept.cols(); ++s) {
    const InterfaceState& state = states[std::size_t(s)];
    Vector normal;
    for (std::size_t k = 0; k < trace.unknowns.size(); ++k)
      normal.push_back((trace.onDirichletSide[k] ? state.uDirichlet : state.uNeumann)[std::size_t(trace.unknowns[k])]);
    const Vector values = keptValues(dofs, normal);
    std::copy(values.begin(), values.end(), kept.col(s));
  }
  return kept;
}

double normalDisplacement(const Vector& displacement, int node, const Direction& normal, int dim)
{
  double u = 0.0;
  for (int k = 0; k < dim; ++k)
    u += displacement[std::size_t(node * dim + k)] * normal[std::size_t(k)];
  return u;
}

/// Largest entry of |K u - f - contact force| over the dofs that are not prescribed, and the scale it is measured with.
struct Imbalance
{
  double largest = 0.0, scale = 0.0;
};

Imbalance imbalance(const BodySystem& system, const BodyTrace* trace, const InterfaceState& state, const Vector& u,
                    const Comm& comm)
{
  Vector residual = multiply(system.K, u, comm);
  Imbalance result;
  for (std::size_t i = 0; i < residual.size(); ++i) {
    residual[i] -= system.load[i];
    result.scale = std::max({result.scale, std::abs(residual[i]), std::abs(system.load[i])});
  }
  for (std::size_t k = 0; trace != nullptr && k < trace->unknowns.size(); ++k) {
    const auto unknown = std::size_t(trace->unknowns[k]);
    const TraceDof& dof = system.dofs.trace[k];
    residual[std::size_t(dof.dof)] -=
        dof.scale * (trace->onDirichletSide[k] ? state.forceDirichlet[unknown] : -state.forceNeumann[unknown]);
  }
  for (std::size_t i = 0; i < residual.size(); ++i)
    if (system.dofs.roles[i] != DofRole::Fixed)
      result.largest = std::max(result.largest, std::abs(residual[i]));
  return result;
}

double ratio(double value, double scale)
{
  return scale > 0.0 ? value / scale : 0.0;
}

} // namespace

std::vector<BodyFields> recoverFields(const Model& model, const CondensedModel& condensed,
                                      const std::vector<InterfaceState>& states, Ledger& ledger)
{
  const auto timer = ledger.time("recover");
  std::vector<BodyFields> all(model.bodies.size());
  const int steps = int(states.size());
  for (std::size_t b = 0; b < all.size(); ++b) {
    const BodySystem& system = condensed.systems[b];
    const BodyTrace* trace = condensed.trace(int(b));
    DenseMatrix load(int(condensed.loads[b].size()), steps);
    for (int s = 0; s < steps; ++s)
      std::copy(condensed.loads[b].begin(), condensed.loads[b].end(), load.col(s));
    const DenseMatrix u = condensed.condensed[b]->expand(
        load, trace == nullptr ? DenseMatrix(0, steps) : keptMatrix(*trace, system.dofs.trace, states));
    for (int s = 0; s < steps; ++s) {
      Vector full = u.column(s);
      for (std::size_t i = 0; i < full.size(); ++i)
        full[i] += system.dofs.prescribed[i];
      all[b].displacement.push_back(system.dofs.frames.toGlobal(full));
      all[b].u.push_back(std::move(full));
    }
  }
  return all;
}

std::vector<ContactNode> contactNodes(const Model& model, const CondensedModel& condensed, const InterfaceState& state,
                                      const std::vector<BodyFields>& fields, std::size_t step)
{
  std::vector<ContactNode> all;
  for (const auto& interface : model.interfaces)
    for (int i = 0; i < interface.numNodes(); ++i) {
      const auto node = all.size();
      const Direction& normal = interface.normals[std::size_t(i)];
      ContactNode entry;
      entry.interface = interface.name;
      entry.point.assign(interface.point(i), interface.point(i) + interface.dim);
      entry.uDirichlet = normalDisplacement(fields[std::size_t(interface.dirichletBody)].displacement[step],
                                            interface.dirichletNodes[std::size_t(i)], normal, interface.dim);
      entry.uNeumann = normalDisplacement(fields[std::size_t(interface.neumannBody)].displacement[step],
                                          interface.neumannNodes[std::size_t(i)], normal, interface.dim);
      entry.gap = interface.gap[std::size_t(i)] - (entry.uDirichlet - entry.uNeumann);
      entry.tractionDirichlet = state.tractionDirichlet[node];
      entry.tractionNeumann = state.tractionNeumann[node];
      all.push_back(std::move(entry));
    }
  for (std::size_t k = 0; k < condensed.interface.nodeOfUnknown.size(); ++k) {
    ContactNode& entry = all[std::size_t(condensed.interface.nodeOfUnknown[k])];
    entry.nodalForce = state.forceDirichlet[k];
    entry.closed = state.closed[k] != 0;
  }
  return all;
}

ResidualSummary residuals(const Model& model, const CondensedModel& condensed, const InterfaceState& state,
                          const std::vector<BodyFields>& fields, const std::vector<ContactNode>& contact,
                          const Comm& comm)
{
  ResidualSummary result;
  double displacement = 0.0;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const auto found = imbalance(condensed.systems[b], condensed.trace(int(b)), state, fields[b].u.back(), comm);
    result.equilibrium = std::max(result.equilibrium, ratio(found.largest, found.scale));
    for (const double u : fields[b].u.back())
      displacement = std::max(displacement, std::abs(u));
  }
  double force = 0.0, opening = displacement, complementarity = 0.0, penetration = 0.0, tension = 0.0;
  for (const auto& node : contact) {
    force = std::max(force, std::abs(node.nodalForce));
    opening = std::max(opening, std::abs(node.gap));
    complementarity = std::max(complementarity, std::abs(node.gap * node.nodalForce));
    penetration = std::max(penetration, -node.gap);
    tension = std::max(tension, node.nodalForce);
  }
  result.complementarity = ratio(complementarity, force * opening);
  result.penetration = ratio(penetration, opening);
  result.tension = ratio(tension, force);
  return result;
}

} // namespace ndframe

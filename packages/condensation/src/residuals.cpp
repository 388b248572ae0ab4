#include <algorithm>
#include <cmath>

#include "ndframe/algebra/shared_values.hpp"
#include "ndframe/condensation/solution.hpp"

namespace ndframe
{
namespace
{

constexpr double lastDigits = 1e-14; ///< round-off of a sum of products over a row of K
constexpr double smallForce = 1e-8; ///< below this part of the scene's largest force a body's own ones may be round-off

/// Forces on the nodes of one body.
struct Balance
{
  double imbalance = 0.0; ///< largest entry of |K u - f - contact force| over the dofs that are not prescribed
  double force = 0.0;     ///< largest load, reaction or contact force
  double roundOff = 0.0;  ///< what a displacement that is wrong in its last digits makes of K u
  bool loaded = false;
};

/// Of all ranks, each of which has looked at its own nodes.
void takeLargestOf(Balance& balance, const Comm& comm)
{
  Vector values{balance.imbalance, balance.force, balance.roundOff, double(balance.loaded)};
  takeLargest(values, comm);
  balance = {values[0], values[1], values[2], values[3] > 0.0};
}

Balance balance(const BodySystem& system, const BodyTrace* trace, const InterfaceState& state, const BodyFields& fields,
                const Comm& comm)
{
  Vector residual = fields.forces.whole();
  Balance result;
  result.roundOff = lastDigits * system.largestDiagonal(comm) * largestEntry(fields.u.back());
  result.force = system.load.largest();
  result.loaded = result.force > 0.0;
  system.load.addTo(residual, -1.0);
  result.force = std::max(result.force, largestEntry(residual));
  if (trace != nullptr) {
    const Vector kept = trace->map.keptForces(trace->forces(state.forceDirichlet, state.forceNeumann));
    for (std::size_t k = 0; k < kept.size(); ++k)
      residual[std::size_t(trace->map.dofs()[k])] -= kept[k];
    if (system.share)
      system.share->annulOthers(residual, system.K.dim);
  }
  for (std::size_t i = 0; i < residual.size(); ++i)
    if (system.dofs.roles[i] != DofRole::Fixed)
      result.imbalance = std::max(result.imbalance, std::abs(residual[i]));
  if (system.share)
    takeLargestOf(result, comm);
  return result;
}

double ratio(double value, double scale)
{
  return scale > 0.0 ? value / scale : 0.0;
}

/// The imbalance over the body's largest force. A body without loads that only follows another or its supports has no
/// force but round-off, which is no imbalance. largestForce, roundOff: of the scene.
double relativeImbalance(const Balance& body, double largestForce, double roundOff)
{
  const bool carriesNothing = !body.loaded && body.force <= roundOff;
  return carriesNothing ? 0.0 : ratio(body.imbalance, std::max(body.force, smallForce * largestForce));
}

/// Per condition what is left of it and its force, one of which is zero.
std::vector<std::pair<double, double>> conditionsOf(const std::vector<ContactNode>& nodes,
                                                    const InterfaceSystem& system)
{
  Vector left, force;
  for (const ContactNode& node : nodes) {
    left.push_back(node.condition);
    force.push_back(node.nodalForce);
  }
  if (system.mortar) {
    left = system.mortar->meansOf(system.atUnknowns(atInterface(std::move(left))));
    force = system.mortar->forcesOf(system.atUnknowns(atInterface(std::move(force))));
  }
  std::vector<std::pair<double, double>> conditions;
  for (std::size_t i = 0; i < left.size(); ++i)
    conditions.emplace_back(left[i], force[i]);
  return conditions;
}

} // namespace

ResidualSummary residuals(const Model& model, const CondensedModel& condensed, const InterfaceState& state,
                          const std::vector<BodyFields>& fields, const std::vector<ContactNode>& contact,
                          const Comm& comm)
{
  ResidualSummary result;
  std::vector<Balance> bodies;
  double opening = 0.0, force = 0.0, roundOff = 0.0;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    bodies.push_back(balance(condensed.systems[b], condensed.trace(int(b)), state, fields[b], comm));
    Vector moved{largestEntry(fields[b].displacement.back())};
    if (model.bodies[b].share)
      takeLargest(moved, comm);
    opening = std::max(opening, moved[0]);
    force = std::max(force, bodies.back().force);
    roundOff = std::max(roundOff, bodies.back().roundOff);
  }
  for (const auto& body : bodies)
    result.equilibrium = std::max(result.equilibrium, relativeImbalance(body, force, roundOff));
  double complementarity = 0.0, penetration = 0.0, tension = 0.0;
  for (const auto& node : contact)
    opening = std::max(opening, std::abs(node.gap));
  for (const auto& [condition, pull] : conditionsOf(contact, condensed.interface)) {
    complementarity = std::max(complementarity, std::abs(condition * pull));
    penetration = std::max(penetration, -condition);
    tension = std::max(tension, pull - roundOff);
  }
  result.complementarity = ratio(complementarity, force * opening);
  result.penetration = ratio(penetration, opening);
  result.tension = ratio(tension, force);
  return result;
}

} // namespace ndframe

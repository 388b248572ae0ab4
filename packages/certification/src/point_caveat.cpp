#include "point_caveat.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "ndframe/algebra/shared_values.hpp"
#include "ndframe/condensation/reactions.hpp"

namespace ndframe
{
namespace
{

/// Of all loads and reactions together, which a reaction sums up with their round-off.
constexpr double roundOff = 1e-9;

/// A force on a point that a support holds.
struct PointForce
{
  double body, support, force;
};

/// The first of those that this rank knows.
std::optional<PointForce> firstForce(const CertifiedScene& scene, const std::vector<NodalField>& reactions,
                                     double largestRoundOff)
{
  for (const int b : scene.model.elasticBodies()) {
    const BodyModel& body = *scene.bodies[std::size_t(b)];
    for (std::size_t s = 0; s < body.supports.size(); ++s)
      for (const NodeConstraint& held : body.supports[s]->holdsPoint()
                                            ? body.supports[s]->constraints(body.mesh, body.nodes)
                                            : std::vector<NodeConstraint>())
      {
        const double* const all = reactions[std::size_t(b)].data() + std::ptrdiff_t(held.node) * body.mesh.dim;
        double force = 0.0;
        for (int k = 0; k < body.mesh.dim; ++k)
          force += held.direction[std::size_t(k)] * all[k];
        if (std::abs(force) > largestRoundOff)
          return PointForce{double(b), double(s), force};
      }
  }
  return std::nullopt;
}

} // namespace

std::string pointCaveat(const CertifiedScene& scene, const Comm& comm)
{
  const std::vector<int> bodies = scene.model.elasticBodies();
  if (std::none_of(bodies.begin(), bodies.end(), [&](int b) {
        const auto& supports = scene.bodies[std::size_t(b)]->supports;
        return std::any_of(supports.begin(), supports.end(), [](const auto& support) { return support->holdsPoint(); });
      }))
    return {};
  Vector total{0.0}; // shares are complete at own nodes
  std::vector<NodalField> reactions;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    reactions.push_back(supportForces(scene.model, scene.condensed, scene.coupling.state, int(b), scene.fields[b]));
    const NodalField load = scene.condensed.systems[b].load.all();
    for (const NodalField* forces : {&std::as_const(reactions[b]), &load})
      for (const double force : *forces)
        total[0] += std::abs(force);
  }
  if (scene.model.told)
    comm.sum(total);
  Vector own;
  if (const auto first = firstForce(scene, reactions, roundOff * total[0]))
    own = {first->body, first->support, first->force};
  const Vector all = gatheredFrom(own, comm);
  if (all.empty())
    return {};
  std::size_t first = 0;
  for (std::size_t i = 3; i < all.size(); i += 3)
    if (std::tie(all[i], all[i + 1]) < std::tie(all[first], all[first + 1]))
      first = i;
  const Support& support = *scene.bodies[std::size_t(all[first])]->supports[std::size_t(all[first + 1])];
  return fmt::format("{} holds a point with a force of {:.3g}, and no stress of finite energy is in equilibrium "
                     "with a force on a point: hold a side, or balance the loads. ",
                     support.params().path(), all[first + 2]);
}

} // namespace ndframe

#include "point_caveat.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "ndframe/condensation/reactions.hpp"

namespace ndframe
{
namespace
{

/// Of all loads and reactions together, which a reaction sums up with their round-off.
constexpr double roundOff = 1e-9;

bool holdsPoint(const Support& support, const Mesh& mesh)
{
  return support.facets(mesh).empty() && !support.holdsMeanMotion();
}

} // namespace

std::string pointCaveat(const CertifiedScene& scene, const Comm& comm)
{
  const bool any = std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const BodyModel* body) {
    return !body->isRigid && !body->share && // shares hold sides
           std::any_of(body->supports.begin(), body->supports.end(),
                       [&](const auto& support) { return holdsPoint(*support, body->mesh); });
  });
  if (!any)
    return {};
  double total = 0.0;
  std::vector<NodalField> reactions;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const NodalField u = scene.condensed.systems[b].dofs.frames.toLocal(scene.solved[b]);
    reactions.push_back(supportForces(scene.model, scene.condensed, scene.coupling.state, int(b), u, comm));
    const NodalField load = scene.condensed.systems[b].load.all();
    for (const NodalField* forces : {&std::as_const(reactions[b]), &load})
      for (const double force : *forces)
        total += std::abs(force);
  }
  for (const int b : scene.model.elasticBodies())
    for (const auto& support : scene.bodies[std::size_t(b)]->supports)
      for (const auto& held :
           support->constraints(scene.bodies[std::size_t(b)]->mesh, scene.bodies[std::size_t(b)]->nodes)) {
        double force = 0.0;
        for (int k = 0; k < scene.bodies[std::size_t(b)]->mesh.dim; ++k)
          force +=
              held.direction[std::size_t(k)] *
              reactions[std::size_t(b)]
                       [std::size_t(held.node) * std::size_t(scene.bodies[std::size_t(b)]->mesh.dim) + std::size_t(k)];
        if (holdsPoint(*support, scene.bodies[std::size_t(b)]->mesh) && std::abs(force) > roundOff * total)
          return fmt::format(
              "{} holds a point with a force of {:.3g}, and no stress of finite energy is in equilibrium "
              "with a force on a point: hold a side, or balance the loads. ",
              support->params().path(), force);
      }
  return {};
}

} // namespace ndframe

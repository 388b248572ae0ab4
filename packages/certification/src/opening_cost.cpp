// What tractions cost where the sides are apart in the solution.

#include <algorithm>
#include <cmath>
#include <limits>

#include "certificate_steps.hpp"
#include "ndframe/admissibility/contact_nodes.hpp"
#include "ndframe/admissibility/smallest_stiffness.hpp"

namespace ndframe
{
namespace
{

/// Per body and law the least eigenvalue; infinite for rigid bodies.
std::vector<Vector> stiffnessOf(const std::vector<const BodyModel*>& bodies)
{
  std::vector<Vector> stiffness;
  for (const BodyModel* body : bodies)
    stiffness.push_back(body->isRigid ? Vector(body->laws.all().size(), std::numeric_limits<double>::infinity())
                                      : smallestStiffness(body->laws));
  return stiffness;
}

} // namespace

Vector openingCost(const CertifiedScene& scene, const Vector& traction)
{
  constexpr double enough = 1.0; // of the largest traction keeps any other away; more would only cost digits
  const double most = enough * largestEntry(traction);
  Vector cost(std::size_t(scene.condensed.interface.C->size()), 0.0);
  const Vector gap = nodalGap(scene.model);
  const std::vector<Vector> ofLaws = stiffnessOf(scene.bodies);
  for (const ContactPatch& patch : scene.patches) {
    const auto opening = patchOpening(scene.bodies, patch, scene.solved);
    double stiffness = std::numeric_limits<double>::infinity();
    for (const PatchSide& side : patch.sides) {
      const auto body = std::size_t(side.body);
      stiffness = std::min(stiffness, ofLaws[body][std::size_t(scene.bodies[body]->laws.number(side.facet.cell))]);
    }
    for (std::size_t i = 0; i < patch.numNodes(scene.order); ++i) {
      const auto node = std::size_t(patch.nodes[i]);
      const double open = gap[node] - dotProduct(patch.normalAt(i), opening[i]);
      const double share = shareOf(patch.dim, scene.order, i);
      const double perSize = patch.dim == 2 ? 1.0 : std::sqrt(patch.measure); // measure / h
      cost[node] -= share * std::min(2.0 * stiffness * perSize * std::max(0.0, open), most * patch.measure);
    }
  }
  return cost;
}

} // namespace ndframe

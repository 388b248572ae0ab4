#include <fmt/format.h>

#include "checks.hpp"
#include "ndframe/scene/regions.hpp"

namespace ndframe
{
namespace
{

constexpr double largestPoisson = 0.45;

} // namespace

/// Linear triangles and tetrahedra are much too stiff where the volume hardly changes.
void findLocking(const Model& model, const SceneSettings& scene, Diagnostics& found)
{
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    for (const auto& material : materialsOf(model.bodies[b], scene.bodies[b]))
      if (const double nu = effectivePoisson(material.law); model.bodies[b].nodes.order == 1 && nu > largestPoisson)
        found.add(material.list.mistake(
            "", fmt::format("elements of order 1 lock at a Poisson ratio of {:.3g} (above {:g}): the "
                            "body comes out too stiff; use Discretization/Order = 2.",
                            nu, largestPoisson)));
}

} // namespace ndframe

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
void findLocking(const Model& model, const Params& deck, Diagnostics& found)
{
  for (const auto& body : model.bodies)
    for (const auto& material : materialsOf(body, deck.sub("Bodies").sub(body.name)))
      if (const double nu = effectivePoisson(material.law); body.nodes.order == 1 && nu > largestPoisson)
        found.add(material.list.mistake(
            "", fmt::format("elements of order 1 lock at a Poisson ratio of {:.3g} (above {:g}): the "
                            "body comes out too stiff; use Discretization/Order = 2.",
                            nu, largestPoisson)));
}

} // namespace ndframe

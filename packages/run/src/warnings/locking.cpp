#include <algorithm>

#include <fmt/format.h>

#include "checks.hpp"
#include "ndframe/scene/regions.hpp"

namespace ndframe
{
namespace
{

constexpr double largestPoisson = 0.45;

/// nu of an isotropic law with the same D, lambda / (2 (lambda + mu)), the largest over the planes. Plane stress, where
/// nothing locks, has nu / (1 + nu) < 1/3 there.
double effectivePoisson(const Elasticity& law)
{
  double largest = 0.0;
  for (int i = 0; i < law.dim; ++i)
    for (int j = 0; j < i; ++j)
      largest = std::max(largest, law(i, j) / (0.5 * (law(i, i) + law(j, j)) + law(i, j)));
  return largest;
}

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

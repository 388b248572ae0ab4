#include <optional>

#include <fmt/format.h>

#include "checks.hpp"
#include "ndframe/scene/regions.hpp"

namespace ndframe
{
namespace
{

constexpr double largestRatio = 1e6; ///< steel over rubber is 1e5

double shearModulus(const Elasticity& law)
{
  const int last = law.strains() - 1;
  return law(last, last);
}

} // namespace

/// Moduli of one scene in different units, or one that was not set.
void findDifferentModuli(const Model& model, const SceneSettings& scene, Diagnostics& found)
{
  std::optional<PlacedMaterial> softest, stiffest;
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    for (const auto& material : materialsOf(model.bodies[b], scene.bodies[b])) {
      const double modulus = shearModulus(material.law);
      if (!softest || modulus < shearModulus(softest->law))
        softest.emplace(material);
      if (!stiffest || modulus > shearModulus(stiffest->law))
        stiffest.emplace(material);
    }
  if (!softest || shearModulus(stiffest->law) <= largestRatio * shearModulus(softest->law))
    return;
  found.add(softest->list.mistake(
      "", fmt::format("it is {:.1g} times as soft as {}: are all moduli set, and in one unit?",
                      shearModulus(stiffest->law) / shearModulus(softest->law), stiffest->list.path())));
}

} // namespace ndframe

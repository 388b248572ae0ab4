#include <algorithm>

#include <fmt/format.h>

#include "checks.hpp"
#include "ndframe/scene/regions.hpp"

namespace ndframe
{

/// Plane strain beside plane stress: the bodies would need different thicknesses to be one scene.
void findDifferentHypotheses(const Model& model, const SceneSettings& scene, Diagnostics& found)
{
  const auto materialOf = [&](std::size_t b) { // those of one body have one hypothesis
    return materialsOf(model.bodies[b], scene.bodies[b]).front().list;
  };
  const auto hypothesis = [&](std::size_t b) { // materials of other projects may have none
    const Params material = materialOf(b);
    return material.has("Hypothesis") ? material.get<std::string>("Hypothesis") : std::string();
  };
  const std::vector<int> bodies = model.elasticBodies();
  const auto first = std::size_t(bodies.front());
  for (const int body : bodies)
    if (const auto b = std::size_t(body); hypothesis(b) != hypothesis(first)) {
      found.add(materialOf(b).mistake(
          "Hypothesis", fmt::format("{} here, {} for body \"{}\": all bodies of a scene must have the same hypothesis.",
                                    hypothesis(b), hypothesis(first), model.bodies[first].name)));
      return;
    }
}

} // namespace ndframe

#include <algorithm>

#include <fmt/format.h>

#include "checks.hpp"

namespace ndframe
{

/// Plane strain beside plane stress: the bodies would need different thicknesses to be one scene.
void findDifferentHypotheses(const Model& model, const Params& deck, Diagnostics& found)
{
  const auto hypothesis = [&](std::size_t b) { // materials of other projects may have none
    const Params material = deck.sub("Bodies").sub(model.bodies[b].name).sub("Material");
    return material.has("Hypothesis") ? material.get<std::string>("Hypothesis") : std::string();
  };
  for (std::size_t b = 1; b < model.bodies.size(); ++b)
    if (hypothesis(b) != hypothesis(0)) {
      found.add(deck.sub("Bodies")
                    .sub(model.bodies[b].name)
                    .sub("Material")
                    .mistake("Hypothesis", fmt::format("{} here, {} for body \"{}\": bodies of one scene have one "
                                                       "hypothesis.",
                                                       hypothesis(b), hypothesis(0), model.bodies[0].name)));
      return;
    }
}

} // namespace ndframe

#include <algorithm>

#include <fmt/format.h>

#include "checks.hpp"
#include "ndframe/scene/regions.hpp"

namespace ndframe
{

/// Plane strain beside plane stress: the bodies would need different thicknesses to be one scene.
void findDifferentHypotheses(const Model& model, const Params& deck, Diagnostics& found)
{
  const auto materialOf = [&](std::size_t b) { // those of one body have one hypothesis
    const BodyModel& body = model.bodies[b];
    return materialsOf(body, deck.sub("Bodies").sub(body.name)).front().list;
  };
  const auto hypothesis = [&](std::size_t b) { // materials of other projects may have none
    const Params material = materialOf(b);
    return material.has("Hypothesis") ? material.get<std::string>("Hypothesis") : std::string();
  };
  for (std::size_t b = 1; b < model.bodies.size(); ++b)
    if (hypothesis(b) != hypothesis(0)) {
      found.add(
          materialOf(b).mistake("Hypothesis", fmt::format("{} here, {} for body \"{}\": bodies of one scene have one "
                                                          "hypothesis.",
                                                          hypothesis(b), hypothesis(0), model.bodies[0].name)));
      return;
    }
}

} // namespace ndframe

#include <algorithm>

#include <fmt/format.h>

#include "checks.hpp"

namespace ndframe
{
namespace
{

/// Part of a body that may have larger strains: at corners they grow without bound as cells get smaller.
constexpr double smallPart = 1e-4;
/// Steel under 2 kPa: nobody computes that. Far below it strains are the round-off of a motion without any.
constexpr double hardlyAny = 1e-8, roundOff = 1e-13;

/// The node of the interfaces with the smallest opening where all are open; nothing where one is closed or there is
/// none.
const ContactNode* nearestOpenNode(const Run& run)
{
  const auto& nodes = run.solved.contact;
  if (nodes.empty() || std::any_of(nodes.begin(), nodes.end(), [](const ContactNode& node) { return node.closed; }))
    return nullptr;
  return &*std::min_element(nodes.begin(), nodes.end(),
                            [](const ContactNode& a, const ContactNode& b) { return a.gap < b.gap; });
}

} // namespace

/// Strains that the theory does not hold for, or that are next to nothing: units of modulus and load that do not fit.
void findStrangeStrain(const Answer& answer, const RunSettings& settings, Diagnostics& found)
{
  const Run& run = answer.run;
  const double limit = settings.strainLimit;
  double largest = 0.0, motion = 0.0;
  for (std::size_t b = 0; b < run.model.bodies.size(); ++b) {
    const BodyModel& body = run.model.bodies[b];
    const PeakSummary& peak = answer.bodies[b].strain;
    const double share = answer.bodies[b].strainedShare;
    largest = std::max(largest, peak.value);
    motion = std::max(motion, answer.bodies[b].displacement.value / run.model.diameterOf(int(b)));
    if (share > smallPart)
      found.add(settings.scene.bodies[b].place.mistake(
          "",
          fmt::format("strains reach {:.2g} at {} and are above {:g} in {:.3g} % of the body: the theory assumes small "
                      "strains. Check the units of loads and moduli; where only ratios matter, raise Strain Limit.",
                      peak.value, pointText(peak.point.data(), body.mesh.dim), limit, 100.0 * share)));
  }
  if (const ContactNode* const node = nearestOpenNode(run); node != nullptr && motion > 0.0 && largest < hardlyAny)
    found.add(settings.scene.interfacesPlace.mistake(
        "", fmt::format("nothing touches, and no body is strained: the smallest remaining opening is {:.4g}, "
                        "in \"{}\" at {}. Move the bodies further towards each other, or look at the gaps.",
                        node->gap, run.model.interfaces[std::size_t(node->interface)].name,
                        pointText(node->point.data(), run.model.bodies.front().mesh.dim))));
  else if (largest > 0.0 && largest < hardlyAny && largest > roundOff * motion)
    found.add(settings.scene.bodiesPlace.mistake(
        "", fmt::format("the largest strain is {:.1e}: such loads hardly deform bodies with "
                        "such moduli. Check their units (modulus in Pa, loads in MPa?).",
                        largest)));
}

} // namespace ndframe

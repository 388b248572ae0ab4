#include "ndframe/run/energy_comparison.hpp"

#include <fmt/format.h>

namespace ndframe
{

void compareEnergies(Run& run, const SceneSettings& scene)
{
  EnergyRecord& record = run.energies.of(SceneIdentity(scene, run.model));
  if (run.certificate->energy && !run.contradiction)
    run.contradiction = record.add(*run.certificate->energy, run.energies.name(run.level));
  run.energy = record;
  if (!run.contradiction)
    return;
  run.certificate->summary.guaranteed = false;
  run.certificate->summary.reason = contradictionText(*run.contradiction);
}

std::string contradictingText(const Contradiction& contradiction)
{
  return fmt::format("the certificates of {} and {} contradict each other", contradiction.earlier, contradiction.later);
}

std::string contradictionText(const Contradiction& contradiction)
{
  const std::string lower = contradiction.newIsLower ? contradiction.later : contradiction.earlier;
  const std::string upper = contradiction.newIsLower ? contradiction.earlier : contradiction.later;
  return fmt::format(
      "{}: the exact energy is not below {:.9g} by {}, and not above {:.9g} by {}. One of them has not seen "
      "all of the data; let loads, gaps and prescribed displacements that vary abruptly do so at the "
      "ends of sides",
      contradictingText(contradiction), contradiction.lower, lower, contradiction.upper, upper);
}

} // namespace ndframe

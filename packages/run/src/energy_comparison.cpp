#include "ndframe/run/energy_comparison.hpp"

#include <fmt/format.h>

namespace ndframe
{

std::optional<Contradiction> compareEnergies(EnergyRecord& record, const Certificate& certificate,
                                             const std::string& name)
{
  return certificate.energy ? record.add(*certificate.energy, name) : std::nullopt;
}

void withdraw(Certificate& certificate, const Contradiction& contradiction)
{
  certificate.summary.guaranteed = false;
  certificate.summary.reason = contradictionText(contradiction);
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

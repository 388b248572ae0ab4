#pragma once

#include <string>

#include "ndframe/run/run.hpp"

namespace ndframe
{

/// Adds a certificate to those of its scene: weak duality binds any two of them (docs/theory.md, section 8). name: what
/// it is called. What is returned says which two cannot both hold.
std::optional<Contradiction> compareEnergies(EnergyRecord& record, const Certificate& certificate,
                                             const std::string& name);
/// The certificate is one of several that cannot all hold: it is not guaranteed.
void withdraw(Certificate& certificate, const Contradiction& contradiction);

/// None without a certificate that holds, or with some that cannot hold together.
std::optional<NumberBracket> bracketOf(const EnergyRecord& record);

/// The bracket with what follows from it: where gaps and prescribed displacements vanish, the work of the loads
/// L(u) = -2 E(u); without loads and gaps, that of the prescribed displacements, 2 E(u). strainEnergy: of the solution.
std::optional<EnergySummary> summarizeEnergy(const Run& run, double strainEnergy);

/// What a user is told, in short and with the numbers.
std::string contradictingText(const Contradiction& contradiction);
std::string contradictionText(const Contradiction& contradiction); ///< with the numbers

} // namespace ndframe

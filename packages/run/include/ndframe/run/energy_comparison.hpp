#pragma once

#include <string>

#include "ndframe/run/run.hpp"

namespace ndframe
{

/// Compares the certificate of the run's state with all others of the scene: weak duality binds any two of them
/// (docs/theory.md, section 8). Where two cannot both hold, this one and all that follow in the run are not guaranteed.
void compareEnergies(Run& run, const SceneSettings& scene);

/// None without a certificate that holds, or with some that cannot hold together.
std::optional<NumberBracket> bracketOf(const EnergyRecord& record);

/// The bracket with what follows from it: where gaps and prescribed displacements vanish, the work of the loads
/// L(u) = -2 E(u); without loads and gaps, that of the prescribed displacements, 2 E(u). Needs fields.
std::optional<EnergySummary> summarizeEnergy(const Run& run);

/// What a user is told, in short and with the numbers.
std::string contradictingText(const Contradiction& contradiction);
std::string contradictionText(const Contradiction& contradiction); ///< with the numbers

} // namespace ndframe

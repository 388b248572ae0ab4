#pragma once

#include "ndframe/certification/error_summary.hpp"
#include "ndframe/coupling/coupling.hpp"

namespace ndframe
{

/// What would make the error smaller, in a few words for the line of the part that is meant: "2 more sweeps would leave
/// the mesh alone", "a finer mesh would help". Empty when one of the two parts is unknown or both are tiny.
///
/// Both parts are indicators, so this is advice and no statement. The number of sweeps comes from the contraction of
/// the last two eps_tau: so many as bring the iteration's part down to half of the mesh's, which then is nearly all.
std::string advice(const ErrorSummary& errors, const std::vector<SweepRecord>& history);

/// True when the mesh's part is the larger one.
bool meshDominates(const ErrorSummary& errors);

} // namespace ndframe

#pragma once

#include <string>

#include "ndframe/run/run_summary.hpp"

namespace ndframe
{

/// Title lines of the levels, and one line a level. replacesTolerance: the sweeps do not end by the deck's tolerance.
std::string levelTitle(const AccuracySummary& summary, bool replacesTolerance);
std::string levelLine(const LevelSummary& level, const std::string& note = {}); ///< note: at its end

/// "target 1 % reached: 0.93 % guaranteed, 1412 dofs, 4 levels, 6 sweeps, 0.05 s", or why it was not.
std::string accuracyText(const AccuracySummary& summary, bool guaranteed);

/// Why a target was missed and what was reached instead; one line. Empty when it was not missed.
std::string missedTarget(const RunSummary& summary);

} // namespace ndframe

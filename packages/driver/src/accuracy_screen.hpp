#pragma once

#include <string>

#include "ndframe/base/params.hpp"
#include "ndframe/io/summary.hpp"

namespace ndframe
{

/// What becomes of the entry of the deck that would stop the sweeps; empty when it has none.
std::string stoppingText(const Params& deck, bool balances);

/// Title lines of the levels (stopping: stoppingText), and one line a level.
std::string levelTitle(const AccuracySummary& summary, const std::string& stopping);
std::string levelLine(const LevelSummary& level, const std::string& note = {});

/// "target 1 % reached: 0.93 % guaranteed, 1412 dofs, 4 levels, 6 sweeps, 0.05 s", or why it was not.
std::string accuracyText(const AccuracySummary& summary, bool guaranteed);

/// Why a target was missed and what was reached instead; one line. Empty when it was not missed.
std::string missedTarget(const RunSummary& summary);

} // namespace ndframe

#pragma once

#include <nlohmann/json.hpp>

#include "ndframe/report/summary_text.hpp"

namespace ndframe
{

using Json = nlohmann::ordered_json;

/// All of a summary.
Json summaryJson(const RunSummary& summary);

/// The certificate; null without one. What was not computed is null.
Json errorsJson(const std::optional<ErrorSummary>& errors);

/// The bracket of the exact energy; null without one.
Json energyJson(const std::optional<EnergySummary>& energy);
Json bracketOrNull(const std::optional<NumberBracket>& bracket);

/// The probes of a deck that has some.
Json probesJson(const std::vector<ProbeSummary>& probes);

/// The levels of a run with a target; null for a run without one.
Json accuracyJson(const std::optional<AccuracySummary>& accuracy);

} // namespace ndframe

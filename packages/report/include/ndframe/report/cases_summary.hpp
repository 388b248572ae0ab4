#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ndframe/run/run_summary.hpp"

namespace ndframe
{

/// What a case of a deck with the list Load Cases left.
struct CaseSummary
{
  std::string name;                                    ///< by Load Cases/Names
  std::vector<std::pair<std::string, double>> factors; ///< by what they multiply
  int exitCode = 0;                                    ///< ExitCode, as of a run of its own
  std::string reason;                                  ///< why the code is not 0
  double seconds = 0.0;                                ///< wall-clock time
  std::optional<RunSummary> results;                   ///< absent when nothing could be computed
};

/// What a run with the list Load Cases leaves.
struct CasesSummary
{
  std::string version;            ///< of ndframe
  std::string title;              ///< of the deck
  std::string deckJson;           ///< the effective deck, with its list Load Cases
  std::vector<CaseSummary> cases; ///< in the order of Load Cases/Names
};

/// NAME.summary.json of a deck with the list Load Cases: under "cases" the name, the factors and the exit code of every
/// case, and as "results" what the summary of a run of its own has; null where there is none.
std::string toJson(const CasesSummary& summary);

} // namespace ndframe

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ndframe/run/run_summary.hpp"

namespace ndframe
{

/// The summary as JSON text (two-space indentation; numbers in the shortest form that reads back exactly; NaN and
/// infinity are null).
std::string toJson(const RunSummary& summary);

/// Looks a number up by a path such as "bodies/punch/energy", "interfaces/contact/contact_force", "coupling/sweeps",
/// "energy", "ledger/counts/factorisations": list entries are found by their "name" (or by index). Booleans count as
/// 0/1. Empty when there is no finite number at that path.
std::optional<double> summaryValue(const RunSummary& summary, const std::string& path);

/// NAME.levels.csv: a line of names, then one line a level; 17 significant digits. What is not known is empty. In two
/// dimensions.
std::string levelsCsv(const std::vector<LevelSummary>& levels);

/// NAME.probes.csv: a line of names, then one line a point or side. Columns that say nothing of a probe are empty.
/// 17 significant digits. 2-D files have no z components, and one moment.
std::string probesCsv(const std::vector<ProbeSummary>& probes, int dim);

} // namespace ndframe

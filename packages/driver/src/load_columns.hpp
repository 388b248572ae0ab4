#pragma once

#include <string>
#include <vector>

#include "ndframe/run/run_summary.hpp"
#include "study_table.hpp"

namespace ndframe
{

// What the table of load cases has besides that of a study.

/// Of all bodies.
double largestDisplacement(const RunSummary& summary);

/// Of all interfaces.
double largestPressure(const RunSummary& summary);

/// Paths of the contact forces of the interfaces and of the reactions of the supports, as far as a case has come to
/// know them.
std::vector<std::string> forcePaths(const std::vector<StudyRow>& rows);

} // namespace ndframe

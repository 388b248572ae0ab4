#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ndframe/driver/main.hpp"
#include "ndframe/run/run_summary.hpp"
#include "study_cases.hpp"

namespace ndframe
{

/// What a case of a study left, or a load case.
struct StudyRow
{
  std::size_t number = 0; ///< from 1
  std::string name;       ///< of the case: its number, or that of a load case
  std::vector<std::string> values;
  std::optional<RunSummary> summary; ///< absent when nothing could be computed
  ExitCode code = ExitCode::Right;
  std::string reason; ///< why the code is not 0
  double seconds = 0.0;
};

/// NAME.study.csv or NAME.cases.csv: a line of names, then one line a case: its number, the values of the parameters
/// that vary, results, work, exit code and reason. A field with a comma, a quote or a line end stands in quotes;
/// numbers that a case does not have are empty. Load cases have largest displacement and pressure, contact forces and
/// reactions, too.
std::string studyCsv(const Study& study, const std::vector<StudyRow>& rows);

/// The screen's table: the line of names, and one line a case.
std::string studyTitle(const Study& study);
std::string studyLine(const Study& study, const StudyRow& row);

/// What the first step along each axis computes again, as far as the decks tell. Faster axes start over in this step,
/// so what they change counts, too.
std::string studyPlan(const Study& study);

/// What all cases together took: "12 cases; 2 factorisations, 22 factors and 22 meshes reused".
std::string studyTotal(const std::vector<StudyRow>& rows);

} // namespace ndframe

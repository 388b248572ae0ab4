#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ndframe/base/log.hpp"
#include "ndframe/driver/run_deck.hpp"
#include "ndframe/report/case_files.hpp"
#include "ndframe/report/cases_summary.hpp"
#include "study_table.hpp"

namespace ndframe
{

/// Runs the cases of a study in one process; each hands on to the next what that does not change, so every answer is
/// that of a run of its own. A case that fails leaves its reason in its row and the study goes on. Load cases on the
/// same meshes hand on their contact, too: their answers are those of runs of their own up to the tolerance.
class StudyRunner
{
public:
  /// `deckName`: the deck as messages and files call it. Everything must live as long as the runner.
  StudyRunner(const Study& study, const std::string& deckName, const Components& components, const Comm& comm,
              const Log& log);

  /// Runs every case with one line on the screen each, and writes NAME.study.csv; of load cases NAME.cases.csv and the
  /// files that they share. Until the last row the rows stand in NAME.study.partial.csv (NAME.cases.partial.csv), which
  /// a study that was stopped leaves behind. Throws InputError when a column names no
  /// number of any case, or when the table cannot be written. `computed` becomes true when the first case begins.
  /// Returns the gravest exit code of all cases.
  ExitCode run(bool& computed);

  /// Reads and checks everything that --check checks, for every case; throws all mistakes.
  ExitCode check();

private:
  void checkColumns();
  StudyRow runCase(std::size_t index);
  void runCases(const std::string& partial, ExitCode& gravest);
  ExitCode solve(const StudyCase& given, StudyRow& row);
  void write(Run& run, const RunSettings& settings, const StudyRow& row);
  void handOnFrom(Run& run);
  void withdraw(const Contradiction& contradiction);
  std::vector<std::string> writeShared(const OutputOptions& output);
  CasesSummary casesSummary() const;
  void writeRows(const std::string& path) const;

  const Study& study_;
  const std::string& deckName_;
  const Components& components_;
  const Comm& comm_;
  const Log& log_;
  Ledger ledger_; ///< of the present case; the factors that are handed on count in it
  Reusable reusable_;
  std::optional<CaseFiles> shared_; ///< by load cases on the same meshes
  std::vector<StudyRow> rows_;
};

} // namespace ndframe

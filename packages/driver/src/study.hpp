#pragma once

#include <string>
#include <vector>

#include "ndframe/base/log.hpp"
#include "ndframe/driver/run_deck.hpp"
#include "study_table.hpp"

namespace ndframe
{

/// Runs the cases of a study in one process; each hands on to the next what that does not change, so every answer is
/// that of a run of its own. A case that fails leaves its reason in its row and the study goes on.
class StudyRunner
{
public:
  /// `deckName`: the deck as messages and files call it. Everything must live as long as the runner.
  StudyRunner(const Study& study, const std::string& deckName, const Components& components, const Comm& comm,
              const Log& log);

  /// Runs every case with one line on the screen each, and writes NAME.study.csv. Until the last row the rows stand in
  /// NAME.study.partial.csv, which a study that was stopped leaves behind. Throws InputError when a column names no
  /// number of any case, or when the table cannot be written. `computed` becomes true when the first case begins.
  /// Returns the gravest exit code of all cases.
  ExitCode run(bool& computed);

  /// Reads and checks everything that --check checks, for every case; throws all mistakes.
  ExitCode check();

private:
  void checkColumns();
  StudyRow runCase(std::size_t index);
  ExitCode solve(const StudyCase& given, StudyRow& row);
  void withdraw(const Contradiction& contradiction);
  void writeRows(const std::string& path) const;

  const Study& study_;
  const std::string& deckName_;
  const Components& components_;
  const Comm& comm_;
  const Log& log_;
  Ledger ledger_; ///< of the present case; the factors that are handed on count in it
  Reusable reusable_;
  std::vector<StudyRow> rows_;
};

} // namespace ndframe

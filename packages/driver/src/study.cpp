#include "study.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "failures.hpp"
#include "ndframe/base/progress.hpp"
#include "ndframe/io/atomic_file.hpp"
#include "ndframe/report/accuracy_screen.hpp"
#include "ndframe/report/html_report.hpp"
#include "ndframe/report/outputs.hpp"
#include "ndframe/report/summary_text.hpp"
#include "ndframe/run/contact_start.hpp"
#include "ndframe/run/energy_comparison.hpp"
#include "ndframe/run/summarize.hpp"
#include "ndframe/run/warnings.hpp"
#include "ndframe/scene/stage.hpp"

namespace ndframe
{
namespace
{

ExitCode graver(ExitCode a, ExitCode b)
{
  constexpr std::array byGravity{ExitCode::Right,        ExitCode::Warned,       ExitCode::ExpectationMissed,
                                 ExitCode::TargetMissed, ExitCode::NotConverged, ExitCode::UserInput,
                                 ExitCode::Bug};
  const auto gravity = [&](ExitCode code) { return std::find(byGravity.begin(), byGravity.end(), code); };
  return gravity(a) < gravity(b) ? b : a;
}

/// Errors are many lines; a row has one.
std::string onOneLine(std::string text)
{
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

std::string missedExpectations(const RunSummary& summary)
{
  std::string missed;
  for (const auto& e : summary.expectations)
    if (!e.met)
      missed += fmt::format("{}missed {}: {:.10g} instead of {:.10g}", missed.empty() ? "" : "; ", e.name, e.value,
                            e.expected);
  return missed;
}

/// Why the code of a case is not 0; empty when it is.
std::string reasonOf(const std::string& failure, const RunSummary& summary)
{
  if (!failure.empty())
    return failure;
  const std::string target = missedTarget(summary), expectations = missedExpectations(summary);
  return target.empty() || expectations.empty() ? target + expectations : target + "; " + expectations;
}

std::string caseName(const std::string& name)
{
  return "case " + name;
}

} // namespace

StudyRunner::StudyRunner(const Study& study, const std::string& deckName, const Components& components,
                         const Comm& comm, const Log& log)
    : study_(study), deckName_(deckName), components_(components), comm_(comm), log_(log), ledger_(&log)
{}

/// Refuses columns that no case has. Reads the meshes of the first case, which it then need not read.
void StudyRunner::checkColumns()
{
  const RunSettings first = readSettings(study_.cases.front().deck);
  try {
    checkDeck(reusable_.model, first, components_, comm_, ledger_);
  } catch (const InputError&) {
    return; // the row of this case will say so
  }
  const auto solver = components_.linearSolvers.build(first.scene.linearSolver);
  Diagnostics diagnostics;
  for (const auto& column : study_.columns) {
    const bool known = std::any_of(study_.cases.begin(), study_.cases.end(), [&](const StudyCase& c) {
      const RunSettings settings = readSettings(c.deck);
      return isQuantity(column, outlineSummary(reusable_.model, settings, *solver, 1), settings);
    });
    if (!known)
      diagnostics.add({deckName_, 0, study_.list(),
                       fmt::format("Columns: \"{}\" is not a number in a case's summary; examples are \"energy\", "
                                   "\"residuals/equilibrium\".",
                                   column)});
  }
  diagnostics.throwIfAny();
}

ExitCode StudyRunner::solve(const StudyCase& given, StudyRow& row)
{
  reusable_.energies.begin(caseName(row.name));
  const RunSettings settings = readSettings(given.deck);
  Run run = runDeck(settings, components_, comm_, ledger_, silentLog(), std::move(reusable_),
                    levelWriter(settings.output, deckName_, comm_, ledger_));
  const ExitCode code = codeOf(run);
  write(run, settings, row);
  copyLedger(run.summary, ledger_, run.startSeconds);
  for (const auto& warning : run.summary.warnings)
    complain(comm_, fmt::format("{}: {}", caseName(row.name), warningText(warning)));
  if (code == ExitCode::Warned)
    row.reason = run.summary.warnings.front().message;
  row.summary = std::move(run.summary);
  if (run.contradiction)
    withdraw(*run.contradiction);
  handOnFrom(run);
  if (code != ExitCode::Warned)
    row.reason = reasonOf(run.failure, *row.summary);
  return code;
}

/// The files of a case that has its own; else its part of those that all share.
void StudyRunner::write(Run& run, const RunSettings& settings, const StudyRow& row)
{
  if (!shared_) {
    writeResults(run, settings.output, deckName_, comm_, ledger_);
  } else if (run.summary.solved) {
    const auto timer = timeStage(ledger_, Stage::Stress);
    shared_->add(run, int(row.number), row.name);
  }
}

/// What the next case may take over. From load case to load case contact goes on with its statuses; after one without a
/// solution it begins as the deck says. Sweeps begin with the deck's traction: another one would stand in the answer as
/// far as their tolerance lets it, and where contact opens altogether it goes away but slowly.
void StudyRunner::handOnFrom(Run& run)
{
  CarriedContact contact;
  if (shared_ && !run.solved.states.empty())
    contact = contactOf(run, {});
  reusable_ = handOn(run);
  reusable_.contact = std::move(contact);
}

/// An earlier case that the present one contradicts is not guaranteed either.
void StudyRunner::withdraw(const Contradiction& contradiction)
{
  for (StudyRow& row : rows_) {
    const std::string name = caseName(row.name);
    if (contradiction.earlier != name && contradiction.earlier.rfind(name + ",", 0) != 0)
      continue;
    row.code = graver(row.code, ExitCode::NotConverged);
    row.reason = contradictionText(contradiction);
    row.summary->errors->guaranteed = false;
    row.summary->errors->reason = row.reason;
    row.summary->errors->energyBracket.reset();
    const OutputOptions output = readSettings(study_.cases[row.number - 1].deck).output;
    if (study_.writesFiles && output.summary)
      writeOnFirstRank(comm_, [&] {
        writeTextAtomically(outputStem(output, deckName_).string() + ".summary.json", toJson(*row.summary));
      });
  }
}

StudyRow StudyRunner::runCase(std::size_t index)
{
  const StudyCase& given = study_.cases[index];
  StudyRow row;
  row.number = index + 1;
  row.name = given.name;
  row.values = given.values;
  ledger_.restart();
  const double start = wallSeconds(), share = double(index) / double(study_.cases.size());
  ledger_.tell(Depth::Case, Progress::part("case", std::int64_t(row.number), std::int64_t(study_.cases.size()), share));
  try {
    row.code = solve(given, row);
  } catch (...) {
    const Failure failure = currentFailure();
    if (failure.code == ExitCode::Bug || (failure.outOfMemory && comm_.size() > 1))
      throw; // the other ranks may know nothing of it
    if (failure.outOfMemory)
      reusable_ = {{}, {}, nullptr, std::move(reusable_.energies)}; // the next case may need the memory
    row.code = failure.code;
    row.reason = failure.outOfMemory ? needsMoreMemory : failure.text;
  }
  row.reason = onOneLine(row.reason);
  row.seconds = wallSeconds() - start;
  return row;
}

void StudyRunner::writeRows(const std::string& path) const
{
  writeOnFirstRank(comm_, [&] { writeTextAtomically(path, studyCsv(study_, rows_)); });
}

ExitCode StudyRunner::check()
{
  Diagnostics mistakes;
  for (const auto& given : study_.cases) {
    try {
      checkDeck(reusable_.model, readSettings(given.deck), components_, comm_, ledger_);
    } catch (const InputError& error) {
      for (const auto& mistake : error.list())
        mistakes.add(mistake);
    }
  }
  mistakes.throwIfAny();
  checkColumns();
  log_.line(fmt::format("  all {} cases are valid; nothing was solved.", study_.cases.size()));
  return ExitCode::Right;
}

/// All cases, one line of the screen each.
void StudyRunner::runCases(const std::string& partial, ExitCode& gravest)
{
  log_.line(studyTitle(study_));
  for (std::size_t i = 0; i < study_.cases.size(); ++i) {
    rows_.push_back(runCase(i));
    gravest = graver(gravest, rows_.back().code);
    log_.line(studyLine(study_, rows_.back()));
    if (!rows_.back().reason.empty())
      log_.line("        " + rows_.back().reason);
    writeRows(partial);
  }
}

CasesSummary StudyRunner::casesSummary() const
{
  CasesSummary summary{versionText(), study_.loads->title, study_.loads->deckJson, {}};
  for (const StudyRow& row : rows_) {
    CaseSummary one{row.name, {}, int(row.code), row.reason, row.seconds, row.summary};
    for (std::size_t p = 1; p < row.values.size(); ++p) // behind the name
      one.factors.emplace_back(study_.axes.front().parameters[p].path, std::stod(row.values[p]));
    summary.cases.push_back(std::move(one));
  }
  return summary;
}

/// What load cases have together besides their table; returns the names.
std::vector<std::string> StudyRunner::writeShared(const OutputOptions& output)
{
  std::vector<std::string> written;
  if (shared_)
    written = shared_->write(ledger_);
  writeOnFirstRank(comm_, [&] {
    if (study_.loads && study_.loads->writesSummary) {
      const std::string stem = outputStem(output, deckName_).replace_filename(study_.fileName).string();
      written.push_back(stem + ".summary.json");
      writeTextAtomically(written.back(), toJson(casesSummary()));
    }
  });
  return written;
}

ExitCode StudyRunner::run(bool& computed)
{
  const double start = wallSeconds();
  const RunSettings first = readSettings(study_.cases.front().deck);
  checkMeshesStay(first, deckName_);
  const OutputOptions& output = first.output;
  for (const StudyCase& one : study_.cases)
    checkNameLength(output, study_.fileName + (study_.loads && study_.writesFiles ? "." + one.name : ""));
  if (study_.writesReport)
    writeOnFirstRank(comm_, [&] { checkReport(output.place); });
  if (!study_.columns.empty())
    checkColumns();
  if (study_.loads && study_.loads->sharesFiles)
    shared_.emplace(output, deckName_, comm_);
  const std::string stem = outputStem(output, deckName_).replace_filename(study_.fileName).string();
  const std::string partial = stem + study_.tableEnding() + ".partial.csv",
                    table = stem + study_.tableEnding() + ".csv";
  writeRows(partial); // a folder that cannot be written in shows before anything is computed
  computed = true;
  ExitCode code = ExitCode::Right;
  runCases(partial, code);
  std::vector<std::string> written = writeShared(output);
  writeRows(table);
  written.push_back(table);
  if (study_.writesReport)
    writeOnFirstRank(comm_, [&] { writeReport(table); });
  std::error_code ignored;
  if (comm_.rank() == 0)
    std::filesystem::remove(partial, ignored);
  noteRemoved(partial);
  log_.line(fmt::format("\n  {}\n  wrote {}   {:.2f} s, {:.0f} MB", studyTotal(rows_), namesText(written),
                        wallSeconds() - start, double(peakMemory()) / 1e6));
  return code;
}

} // namespace ndframe

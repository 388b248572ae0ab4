#include <filesystem>

#include <fmt/format.h>

#include "ndframe/io/atomic_file.hpp"
#include "ndframe/report/contact_table.hpp"
#include "ndframe/report/html_report.hpp"
#include "ndframe/report/outputs.hpp"
#include "ndframe/report/summary_text.hpp"
#include "ndframe/run/run.hpp"
#include "ndframe/run/summarize.hpp"
#include "ndframe/scene/stage.hpp"
#include "run_fields.hpp"

namespace ndframe
{
namespace
{

constexpr const char *fieldsEnding = ".e", *contactEnding = ".contact.csv", *levelsEnding = ".levels.csv",
                     *probesEnding = ".probes.csv";

void writeExodusFile(const Run& run, const std::vector<ExodusStep>& steps, const std::string& path,
                     const std::string& deckName)
{
  const ExodusScene scene = exodusScene(run);
  writeExodus(path, scene.title, scene.bodies, scene.sides, steps, exodusRecords(deckName));
}

std::string levelPath(const std::string& stem, int level)
{
  return fmt::format("{}.level-{:02}{}", stem, level, fieldsEnding);
}

/// The last state on the mesh of a level; the level stands for its time, so that ParaView plays the series.
void writeLevel(const Run& run, int level, const OutputOptions& output, const std::string& deckName, Ledger& ledger)
{
  const auto timer = timeStage(ledger, Stage::WriteLevels);
  ExodusStep step = exodusStep(run, output, run.solved.states.size() - 1);
  step.time = level;
  ledger.count("bytes written", writeAtomically(levelPath(outputStem(output, deckName).string(), level),
                                                [&](const std::string& temporary) {
                                                  writeExodusFile(run, {step}, temporary, deckName);
                                                }));
}

/// Names the files of the levels; those that a longer run has left are removed.
void addLevelFiles(const AccuracySummary& accuracy, const std::string& stem, std::vector<std::string>& written)
{
  for (const auto& level : accuracy.levels)
    written.push_back(levelPath(stem, level.level));
  for (int left = int(accuracy.levels.size()) + 1; std::filesystem::exists(levelPath(stem, left)); ++left)
    removeEarlier(levelPath(stem, left));
}

/// What a run with a target leaves of its levels, whether the last one has a solution or not.
void writeLevels(const Run& run, const OutputOptions& output, const std::string& stem, Ledger& ledger,
                 std::vector<std::string>& written)
{
  if (output.allLevels)
    addLevelFiles(*run.summary.accuracy, stem, written);
  if (!run.plan.runs(Stage::LevelTable))
    return;
  const auto timer = timeStage(ledger, Stage::Write);
  written.push_back(stem + levelsEnding);
  ledger.count("bytes written", writeTextAtomically(written.back(), levelsCsv(run.summary.accuracy->levels)));
}

/// Writes the fields and the contact table that Output asks for; returns the files' names.
std::vector<std::string> writeSolution(const Run& run, const OutputOptions& output, const std::string& stem,
                                       const std::string& deckName, Ledger& ledger)
{
  std::vector<std::string> written;
  std::vector<ExodusStep> steps;
  if (run.plan.runs(Stage::Stress)) {
    const auto timer = timeStage(ledger, Stage::Stress);
    for (std::size_t s = 0; s < run.solved.states.size(); ++s)
      steps.push_back(exodusStep(run, output, s));
  }
  if (run.plan.runs(Stage::Write)) {
    const auto timer = timeStage(ledger, Stage::Write);
    if (run.plan.runs(Stage::Stress)) {
      written.push_back(stem + fieldsEnding);
      ledger.count("bytes written", writeAtomically(written.back(), [&](const std::string& temporary) {
                     writeExodusFile(run, steps, temporary, deckName);
                   }));
    }
    if (run.plan.runs(Stage::ContactTable)) {
      written.push_back(stem + contactEnding);
      ledger.count("bytes written", writeTextAtomically(written.back(), contactCsv(run)));
    }
    if (output.probeTable) {
      written.push_back(stem + probesEnding);
      ledger.count("bytes written", writeTextAtomically(written.back(), probesCsv(run.summary.probes,
                                                                                  run.model.bodies.front().mesh.dim)));
    }
  }
  return written;
}

/// An earlier run's solution must not stand beside the summary of a run that has none.
void removeSolution(const Plan& plan, const OutputOptions& output, const std::string& stem)
{
  if (output.probeTable)
    removeEarlier(stem + probesEnding);
  if (plan.runs(Stage::Stress))
    removeEarlier(stem + fieldsEnding);
  if (plan.runs(Stage::ContactTable))
    removeEarlier(stem + contactEnding);
}

/// The files that Output asks for, written on one rank; the summary comes after those whose cost it tells, the report
/// after the summary, of which it is made.
std::vector<std::string> writeFiles(Run& run, const OutputOptions& output, const std::string& deckName, Ledger& ledger)
{
  const std::string stem = outputStem(output, deckName).string();
  std::vector<std::string> written;
  if (run.summary.solved)
    written = writeSolution(run, output, stem, deckName, ledger);
  else
    removeSolution(run.plan, output, stem);
  if (run.summary.accuracy)
    writeLevels(run, output, stem, ledger, written);
  copyLedger(run.summary, ledger, run.startSeconds);
  if (output.summary) {
    written.push_back(stem + ".summary.json");
    writeTextAtomically(written.back(), toJson(run.summary));
  }
  if (output.report) {
    written.push_back(stem + ".report.html");
    writeReport(stem + ".summary.json");
  }
  return written;
}

} // namespace

LevelObserver levelWriter(const OutputOptions& output, const std::string& name, const Comm& comm, Ledger& ledger)
{
  if (!output.allLevels)
    return {};
  return
      [&](const Run& run, int level) { writeOnFirstRank(comm, [&] { writeLevel(run, level, output, name, ledger); }); };
}

std::vector<std::string> writeResults(Run& run, const OutputOptions& output, const std::string& name, const Comm& comm,
                                      Ledger& ledger)
{
  std::vector<std::string> written;
  writeOnFirstRank(comm, [&] { written = writeFiles(run, output, name, ledger); });
  return written;
}

} // namespace ndframe

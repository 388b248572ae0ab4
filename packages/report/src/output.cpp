#include <filesystem>

#include <fmt/format.h>

#include "ndframe/io/atomic_file.hpp"
#include "ndframe/io/exodus_pieces.hpp"
#include "ndframe/report/contact_table.hpp"
#include "ndframe/report/html_report.hpp"
#include "ndframe/report/outputs.hpp"
#include "ndframe/report/summary_text.hpp"
#include "ndframe/run/run.hpp"
#include "ndframe/run/summarize.hpp"
#include "ndframe/scene/stage.hpp"
#include "run_fields.hpp"
#include "scene_file.hpp"

namespace ndframe
{
namespace
{

constexpr const char *fieldsEnding = ".e", *contactEnding = ".contact.csv", *levelsEnding = ".levels.csv",
                     *probesEnding = ".probes.csv";

std::string levelPath(const std::string& stem, int level)
{
  return fmt::format("{}.level-{:02}{}", stem, level, fieldsEnding);
}

/// A file of fields to be written.
struct FieldsFile
{
  std::string path;
  std::string deckName;
  Stage stage; ///< what writing counts as
  /// Called by the ranks that write.
  std::function<std::vector<ExodusStep>()> makeSteps;
};

/// As one file by rank 0, or in pieces by all; returns the names. Collective.
std::vector<std::string> writeFields(const Run& run, const OutputOptions& output, const FieldsFile& file,
                                     const Comm& comm, Ledger& ledger)
{
  const ExodusScene scene = exodusScene(run);
  std::vector<std::string> written;
  if (isWrittenByAll(output, scene, comm)) {
    const std::vector<ExodusStep> steps = file.makeSteps();
    const auto timer = timeStage(ledger, file.stage);
    return writeByAll(file.path, output, {scene, steps, exodusRecords(file.deckName)}, comm, ledger);
  }
  writeOnFirstRank(comm, [&] {
    const std::vector<ExodusStep> steps = file.makeSteps();
    const auto timer = timeStage(ledger, file.stage);
    written = writeWhole(file.path, {scene, steps, exodusRecords(file.deckName)}, ledger);
  });
  return written;
}

/// The last state on the mesh of a level; the level stands for its time, so that ParaView plays the series.
void writeLevel(const Run& run, int level, const OutputOptions& output, const std::string& deckName, const Comm& comm,
                Ledger& ledger)
{
  const auto makeStep = [&] {
    const auto timer = timeStage(ledger, Stage::WriteLevels);
    ExodusStep step = exodusStep(run, output, run.solved.states.size() - 1);
    step.time = level;
    return std::vector<ExodusStep>{std::move(step)};
  };
  writeFields(run, output,
              {levelPath(commonStem(output, deckName, comm), level), deckName, Stage::WriteLevels, makeStep}, comm,
              ledger);
}

/// The states that the deck asks for.
std::vector<std::string> writeStates(const Run& run, const OutputOptions& output, const std::string& stem,
                                     const std::string& deckName, const Comm& comm, Ledger& ledger)
{
  const auto makeSteps = [&] {
    const auto timer = timeStage(ledger, Stage::Stress);
    std::vector<ExodusStep> steps;
    for (std::size_t s = 0; s < run.solved.states.size(); ++s)
      steps.push_back(exodusStep(run, output, s));
    return steps;
  };
  return writeFields(run, output, {stem + fieldsEnding, deckName, Stage::Write, makeSteps}, comm, ledger);
}

/// Names the files of the levels; those that a longer run has left are removed.
void addLevelFiles(const AccuracySummary& accuracy, const std::string& stem, std::vector<std::string>& written)
{
  const auto filesOf = [&](int level) {
    std::vector<std::string> files = piecesBeside(levelPath(stem, level));
    if (std::filesystem::exists(levelPath(stem, level)))
      files.push_back(levelPath(stem, level));
    return files;
  };
  for (const auto& level : accuracy.levels)
    for (const std::string& file : filesOf(level.level))
      written.push_back(file);
  for (int left = int(accuracy.levels.size()) + 1; !filesOf(left).empty(); ++left)
    removeScene(levelPath(stem, left));
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

/// Writes the tables of a solution that Output asks for.
void writeTables(const Run& run, const OutputOptions& output, const std::string& stem, Ledger& ledger,
                 std::vector<std::string>& written)
{
  if (!run.plan.runs(Stage::Write))
    return;
  const auto timer = timeStage(ledger, Stage::Write);
  if (run.plan.runs(Stage::ContactTable)) {
    written.push_back(stem + contactEnding);
    ledger.count("bytes written", writeTextAtomically(written.back(), contactCsv(run)));
  }
  if (output.probeTable) {
    written.push_back(stem + probesEnding);
    ledger.count("bytes written",
                 writeTextAtomically(written.back(), probesCsv(run.summary.probes, run.model.bodies.front().mesh.dim)));
  }
}

/// An earlier run's solution must not stand beside the summary of a run that has none.
void removeSolution(const Plan& plan, const OutputOptions& output, const std::string& stem)
{
  if (output.probeTable)
    removeEarlier(stem + probesEnding);
  if (plan.runs(Stage::Stress))
    removeScene(stem + fieldsEnding);
  if (plan.runs(Stage::ContactTable))
    removeEarlier(stem + contactEnding);
}

/// The files beside the fields, written on one rank; the summary comes after those whose cost it tells, the report
/// after the summary, of which it is made.
void writeFiles(Run& run, const OutputOptions& output, const std::string& stem, Ledger& ledger,
                std::vector<std::string>& written)
{
  if (run.summary.solved)
    writeTables(run, output, stem, ledger, written);
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
}

} // namespace

LevelObserver levelWriter(const OutputOptions& output, const std::string& name, const Comm& comm, Ledger& ledger)
{
  if (!output.allLevels)
    return {};
  return [&](const Run& run, int level) { writeLevel(run, level, output, name, comm, ledger); };
}

std::vector<std::string> writeResults(Run& run, const OutputOptions& output, const std::string& name, const Comm& comm,
                                      Ledger& ledger)
{
  const std::string stem = commonStem(output, name, comm);
  std::vector<std::string> written;
  if (run.summary.solved && run.plan.runs(Stage::Stress))
    written = writeStates(run, output, stem, name, comm, ledger);
  writeOnFirstRank(comm, [&] { writeFiles(run, output, stem, ledger, written); });
  return written;
}

} // namespace ndframe

#include "ndframe/report/checkpoint_file.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ndframe/algebra/from_rank_zero.hpp"
#include "ndframe/io/atomic_file.hpp"
#include "ndframe/report/checkpoint_bytes.hpp"
#include "ndframe/report/outputs.hpp"
#include "ndframe/run/summarize.hpp"
#include "ndframe/scene/stage.hpp"

namespace ndframe
{
namespace
{

std::string checkpointPath(const OutputOptions& output, const std::string& deckName)
{
  return outputStem(output, deckName).string() + ".checkpoint";
}

std::string contentsOf(const std::string& path)
{
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored))
    throw InputError(fmt::format("there is no \"{}\" to continue from: a run with Output/Checkpoint = true writes it "
                                 "when its first level is done; run without --restart, from the beginning.",
                                 path));
  std::ifstream file(path, std::ios::binary);
  if (!std::filesystem::is_regular_file(path, ignored) || !file)
    throw InputError(fmt::format("cannot read \"{}\"; run without --restart, from the beginning.", path));
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (text.empty())
    throw InputError(fmt::format("\"{}\" is empty; run without --restart, from the beginning.", path));
  return text;
}

Checkpoint readCheckpoint(const std::string& path, const Comm& comm)
{
  Checkpoint checkpoint =
      checkpointFromBytes(fromRankZero(comm, [&] { return contentsOf(path); }), path, versionText());
  if (checkpoint.isFinished)
    throw InputError(fmt::format(
        "the run of \"{}\" has reached its target, and nothing is left to do; it wrote {}. "
        "Without --restart it runs again.",
        path, checkpoint.results.empty() ? "nothing" : fmt::format("{}", fmt::join(checkpoint.results, ", "))));
  return checkpoint;
}

} // namespace

void openCheckpoint(CheckpointFile& file, const RunSettings& settings, const std::string& deckName, bool goesOn,
                    const Comm& comm, Ledger& ledger, const Log& log)
{
  const OutputOptions& output = settings.output;
  if (goesOn && !settings.accuracy)
    throw InputError("--restart continues from the levels of a run with a target, and the deck has no list Accuracy; "
                     "run without --restart.");
  if (!goesOn && !output.checkpoint)
    return;
  Restart& restart = file.restart;
  writeOnFirstRank(comm, [&] { restart.file = checkpointPath(output, deckName); });
  comm.broadcast(restart.file);
  if (goesOn) {
    restart.from = readCheckpoint(restart.file, comm);
    const std::size_t levels = restart.from->levels.size();
    log.line(fmt::format("  continues from {}: {} not solved again\n", restart.file,
                         levels == 1 ? "level 1 is" : fmt::format("levels 1 to {} are", levels)));
  }
  if (!output.checkpoint)
    return;
  restart.write = [&comm, &ledger, path = restart.file](const Checkpoint& checkpoint) {
    const auto timer = timeStage(ledger, Stage::Write);
    writeOnFirstRank(comm, [&] { writeTextAtomically(path, toBytes(checkpoint)); });
  };
  restart.keep = [&file](Checkpoint&& checkpoint) { file.last = std::move(checkpoint); };
}

void endCheckpoint(CheckpointFile& file, const Run& run, const std::vector<std::string>& written, const Comm& comm)
{
  if (!file.restart.write || !run.summary.accuracy)
    return;
  if (run.summary.accuracy->reached) {
    file.last.emplace();
    file.last->version = versionText();
    file.last->deckJson = run.summary.deckJson;
    file.last->isFinished = true;
    file.last->results = written;
  }
  if (file.last)
    writeOnFirstRank(comm, [&] { writeTextAtomically(file.restart.file, toBytes(*file.last)); });
}

} // namespace ndframe

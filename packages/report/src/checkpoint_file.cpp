#include "ndframe/report/checkpoint_file.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ndframe/algebra/from_rank_zero.hpp"
#include "ndframe/io/atomic_file.hpp"
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
    throw InputError(fmt::format("there is no \"{}\" to go on from: a run with Output/Checkpoint = true leaves it when "
                                 "its first level is done; run without --restart, from the beginning.",
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

Restart restartOf(const OutputOptions& output, const std::string& deckName, bool goesOn, const Comm& comm,
                  Ledger& ledger)
{
  Restart restart;
  if (!goesOn && !output.checkpoint)
    return restart;
  writeOnFirstRank(comm, [&] { restart.file = checkpointPath(output, deckName); });
  comm.broadcast(restart.file);
  if (goesOn)
    restart.from = readCheckpoint(restart.file, comm);
  if (output.checkpoint)
    restart.write = [&comm, &ledger, path = restart.file](const Checkpoint& checkpoint) {
      const auto timer = timeStage(ledger, Stage::Write);
      writeOnFirstRank(comm, [&] { writeTextAtomically(path, toBytes(checkpoint)); });
    };
  return restart;
}

void endCheckpoint(const Run& run, const OutputOptions& output, const std::string& deckName,
                   const std::vector<std::string>& written, const Comm& comm)
{
  if (!output.checkpoint || !run.summary.accuracy || !run.summary.accuracy->reached)
    return;
  Checkpoint checkpoint;
  checkpoint.version = versionText();
  checkpoint.deckJson = run.summary.deckJson;
  checkpoint.isFinished = true;
  checkpoint.results = written;
  writeOnFirstRank(comm, [&] { writeTextAtomically(checkpointPath(output, deckName), toBytes(checkpoint)); });
}

} // namespace ndframe

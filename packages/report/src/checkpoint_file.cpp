#include "ndframe/report/checkpoint_file.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "checkpoint_pieces.hpp"
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

Checkpoint readCheckpoint(const std::string& path, const Comm& comm)
{
  Checkpoint checkpoint =
      checkpointFromBytes(fromRankZero(comm, [&] { return contentsOf(path); }), path, versionText());
  if (checkpoint.isFinished)
    throw InputError(fmt::format(
        "the run of \"{}\" is finished, and nothing is left to do; it wrote {}. "
        "Without --restart it runs again.",
        path, checkpoint.results.empty() ? "nothing" : fmt::format("{}", fmt::join(checkpoint.results, ", "))));
  return checkpoint;
}

/// "level 1 is", "levels 1 to 3 and 40 sweeps of the next are", "1 status pass is".
std::string partsOf(const Checkpoint& checkpoint)
{
  const auto levels = int(checkpoint.levels.size());
  int steps = 0;
  std::string kind;
  if (checkpoint.sweeps) {
    const SweepsDone& done = checkpoint.sweeps->done;
    steps = done.passes ? done.passes->passes : int(done.history.size());
    kind = done.passes ? (steps == 1 ? "status pass" : "status passes") : steps == 1 ? "sweep" : "sweeps";
  }
  std::vector<std::string> parts;
  if (levels > 0)
    parts.push_back(levels == 1 ? "level 1" : fmt::format("levels 1 to {}", levels));
  if (steps > 0)
    parts.push_back(fmt::format("{} {}{}", steps, kind, levels > 0 ? " of the next" : ""));
  return fmt::format("{} {}", fmt::join(parts, " and "), levels + steps == 1 ? "is" : "are");
}

} // namespace

void openCheckpoint(CheckpointFile& file, const RunSettings& settings, const std::string& deckName, bool goesOn,
                    const Comm& comm, const Log& log)
{
  const OutputOptions& output = settings.output;
  if (!goesOn && !output.checkpoint)
    return;
  Restart& restart = file.restart;
  writeOnFirstRank(comm, [&] { restart.file = checkpointPath(output, deckName); });
  comm.broadcast(restart.file);
  if (goesOn) {
    restart.from = readCheckpoint(restart.file, comm);
    readCheckpointPieces(restart.file, *restart.from, comm);
    log.line(fmt::format("  continues from {}: {} not solved again\n", restart.file, partsOf(*restart.from)));
  }
  if (!output.checkpoint)
    return;
  restart.sweeps = output.checkpointSweeps;
  restart.write = [&comm, path = restart.file](const Checkpoint& checkpoint) {
    if (isInPieces(checkpoint))
      return writeCheckpointPieces(path, checkpoint, comm);
    writeOnFirstRank(comm, [&] {
      writeTextAtomically(path, toBytes(checkpoint));
      removeCheckpointPieces(path, checkpoint.stamp);
    });
  };
  restart.keep = [&file](Checkpoint&& checkpoint) { file.last = std::move(checkpoint); };
}

void endCheckpoint(CheckpointFile& file, const Run& run, const std::vector<std::string>& written, const Comm& comm)
{
  if (!file.restart.write)
    return;
  if (run.summary.accuracy ? run.summary.accuracy->reached : run.summary.solved && run.failure.empty()) {
    file.last.emplace();
    file.last->version = versionText();
    file.last->deckJson = run.summary.deckJson;
    file.last->isFinished = true;
    file.last->results = written;
  }
  if (file.last)
    writeOnFirstRank(comm, [&] {
      writeTextAtomically(file.restart.file, toBytes(*file.last));
      removeCheckpointPieces(file.restart.file, file.last->stamp);
    });
}

} // namespace ndframe

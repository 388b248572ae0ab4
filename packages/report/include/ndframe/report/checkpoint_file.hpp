#pragma once

#include "ndframe/accuracy/adaptive_run.hpp"
#include "ndframe/base/log.hpp"

namespace ndframe
{

/// NAME.checkpoint of a run, as long as it runs.
struct CheckpointFile
{
  Restart restart;                ///< for runDeck()
  std::optional<Checkpoint> last; ///< of a run that a limit has ended
};

/// What the run goes on from and what it leaves (Output/Checkpoint). goesOn: --restart; then the file is read by rank
/// 0, and InputError says what is wrong with it, also that its run is finished; `log` says what is not solved again.
/// Everything must live as long as `file`, which must not move. Collective.
void openCheckpoint(CheckpointFile& file, const RunSettings& settings, const std::string& deckName, bool goesOn,
                    const Comm& comm, const Log& log);

/// When the results are written: marks NAME.checkpoint as that of a finished run (its target reached, or its sweeps
/// converged), or leaves the last level of one that a limit has ended. Collective.
void endCheckpoint(CheckpointFile& file, const Run& run, const std::vector<std::string>& written, const Comm& comm);

} // namespace ndframe

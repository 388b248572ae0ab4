#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "ndframe/live/progress_state.hpp"

namespace ndframe
{

class Log;

/// What a run did: exact counts (factorisations, back-solves, sweeps, ...) and, per stage, seconds and peak memory.
///
/// Tests assert on the counts; the seconds are for people. One rank's view: counts are the same on all ranks. Threads
/// may count and time at once: a stage's seconds are then those of all threads, and its peak may leave out what was
/// before another stage began. Read it when they have ended.
class Ledger
{
public:
  /// A stage of the run, all its passes together.
  struct Stage
  {
    std::string name;           ///< as given to time()
    double seconds = 0.0;       ///< wall-clock time of all passes
    std::int64_t peakBytes = 0; ///< largest resident size while the stage ran (VmHWM, reset at its start)
  };

  /// Times a stage from construction to destruction. Stages of the same name are added up. Stages do not nest.
  class Timer
  {
  public:
    Timer(Ledger& ledger, std::string name); ///< the stage begins; the ledger must outlive it
    ~Timer();
    Timer(const Timer&) = delete;
    Timer& operator=(const Timer&) = delete;

  private:
    Ledger& ledger_;
    std::string name_;
    double start_;
  };

  /// With a log given, its live line shows the stages and how far they are.
  explicit Ledger(const Log* live = nullptr) : live_(live) {}

  void count(const std::string& what, std::int64_t amount = 1); ///< adds to a count; new ones begin at 0
  /// How far something is: shown, not kept. Costs a lock.
  void tell(Depth depth, const Progress& progress) const;
  /// Forgets all counts and stages: another run begins, and factors of the last one may go on counting here.
  void restart();
  /// What a run has counted and timed that this one goes on with, in place of all so far.
  void restore(std::map<std::string, std::int64_t> counts, std::vector<Stage> stages);
  /// 0 for what never happened.
  std::int64_t counted(const std::string& what) const;
  const std::map<std::string, std::int64_t>& counts() const { return counts_; } ///< by name
  const std::vector<Stage>& stages() const { return stages_; } ///< in the order in which they first ended
  /// Times a stage as long as the result lives.
  [[nodiscard]] Timer time(std::string stage) { return Timer(*this, std::move(stage)); }

private:
  const Log* live_;
  std::mutex mutex_; ///< of what follows
  std::map<std::string, std::int64_t> counts_;
  std::vector<Stage> stages_;
};

/// Largest resident size of this process so far, in bytes (VmHWM).
std::int64_t peakMemory();

/// Wall-clock seconds since an arbitrary origin.
double wallSeconds();

} // namespace ndframe

#include "ndframe/base/ledger.hpp"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <string>
#include <utility>

#include "ndframe/base/log.hpp"
#include "ndframe/base/progress.hpp"

namespace ndframe
{

namespace
{

/// VmHWM, the kernel's high-water mark of the resident size; 0 where /proc does not tell.
std::int64_t highWaterMark()
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::int64_t kibibytes = 0;
    if (word == "VmHWM:" && status >> kibibytes)
      return kibibytes * 1024;
  }
  return 0;
}

/// The largest mark seen before a reset: the run's peak outlives the resets.
std::int64_t& peakBeforeReset()
{
  static std::int64_t bytes = 0;
  return bytes;
}

/// Lets the mark start again at the present resident size. Where the kernel refuses, stages report the run's peak so
/// far.
void resetHighWaterMark()
{
  peakBeforeReset() = peakMemory();
  std::ofstream("/proc/self/clear_refs") << "5";
}

} // namespace

Ledger::Timer::Timer(Ledger& ledger, std::string name) : ledger_(ledger), name_(std::move(name)), start_(wallSeconds())
{
  const std::lock_guard<std::mutex> lock(ledger_.mutex_);
  resetHighWaterMark();
  noteStage(name_);
  if (ledger_.live_)
    ledger_.live_->beginStage(name_);
}

Ledger::Timer::~Timer()
{
  const std::lock_guard<std::mutex> lock(ledger_.mutex_);
  if (ledger_.live_)
    ledger_.live_->endStage(name_);
  noteStage({});
  auto& stages = ledger_.stages_;
  auto stage = std::find_if(stages.begin(), stages.end(), [&](const Stage& s) { return s.name == name_; });
  if (stage == stages.end())
    stage = stages.insert(stages.end(), Stage{name_, 0.0, 0});
  stage->seconds += wallSeconds() - start_;
  stage->peakBytes = std::max(stage->peakBytes, highWaterMark());
}

void Ledger::count(const std::string& what, std::int64_t amount)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  counts_[what] += amount;
}

void Ledger::tell(Depth depth, const Progress& progress) const
{
  if (live_)
    live_->tell(depth, progress);
}

void Ledger::restore(std::map<std::string, std::int64_t> counts, std::vector<Stage> stages)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  counts_ = std::move(counts);
  stages_ = std::move(stages);
}

void Ledger::restart()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  counts_.clear();
  stages_.clear();
}

std::int64_t Ledger::counted(const std::string& what) const
{
  const auto found = counts_.find(what);
  return found == counts_.end() ? 0 : found->second;
}

std::int64_t peakMemory()
{
  return std::max(peakBeforeReset(), highWaterMark());
}

double wallSeconds()
{
  using namespace std::chrono;
  return duration<double>(steady_clock::now().time_since_epoch()).count();
}

} // namespace ndframe

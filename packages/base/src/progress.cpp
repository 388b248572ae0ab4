#include "ndframe/base/progress.hpp"

#include <mutex>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace ndframe
{
namespace
{

std::mutex mutex; ///< of what follows
std::string stageNow;
std::set<std::string> written;

} // namespace

void noteStage(const std::string& stage)
{
  const std::lock_guard<std::mutex> lock(mutex);
  stageNow = stage;
}

void noteWritten(const std::string& file)
{
  const std::lock_guard<std::mutex> lock(mutex);
  written.insert(file);
}

void noteRemoved(const std::string& file)
{
  const std::lock_guard<std::mutex> lock(mutex);
  written.erase(file);
}

std::string lastWords(const std::string& cause)
{
  const std::lock_guard<std::mutex> lock(mutex);
  const std::string when = stageNow.empty() ? "" : fmt::format(" in the stage \"{}\"", stageNow);
  const std::string kept = written.empty() ? "this run has written no file."
                                           : fmt::format("complete files of this run: {}.", fmt::join(written, ", "));
  return fmt::format("{}{}; {}", cause, when, kept);
}

} // namespace ndframe

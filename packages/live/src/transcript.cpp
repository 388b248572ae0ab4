#include "ndframe/live/transcript.hpp"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <ctime>
#include <fstream>
#include <mutex>
#include <optional>

#include <fmt/chrono.h>
#include <fmt/format.h>

namespace ndframe
{
namespace
{

using Clock = std::chrono::steady_clock;

std::mutex mutex; ///< of what follows
std::optional<std::ofstream> transcript;
std::string name;
Clock::time_point begin;

void writeLine(const std::string& text)
{
  const std::lock_guard<std::mutex> lock(mutex);
  if (transcript)
    *transcript << text << '\n' << std::flush; // complete also when the process is killed
}

std::tm utc()
{
  return fmt::gmtime(std::time(nullptr));
}

} // namespace

std::string openTranscript(const std::string& file, const std::string& title)
{
  {
    const std::lock_guard<std::mutex> lock(mutex);
    errno = 0;
    transcript.emplace(file);
    name = file;
    begin = Clock::now();
    if (!*transcript) {
      transcript.reset();
      return errno != 0 ? std::strerror(errno) : "it is not a file";
    }
  }
  writeLine(fmt::format("# {:%Y-%m-%d %H:%M:%S} UTC  {}", utc(), title));
  return {};
}

void transcribe(const std::string& text)
{
  writeLine(text);
}

void transcribeStage(const std::string& stage)
{
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  writeLine(fmt::format("# {:%H:%M:%S}  +{:.3f} s  {}", utc(), seconds, stage));
}

std::string closeTranscript()
{
  const std::lock_guard<std::mutex> lock(mutex);
  if (!transcript)
    return {};
  errno = 0;
  transcript->close();
  const bool complete = bool(*transcript);
  transcript.reset();
  return complete ? ""
                  : fmt::format("cannot write \"{}\" (--log): {}", name,
                                errno != 0 ? std::strerror(errno) : "an earlier write failed");
}

} // namespace ndframe

#include "failures.hpp"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string_view>

#include <fmt/format.h>
#include <unistd.h>

#include "ndframe/live/transcript.hpp"
#include "screen_files.hpp"

namespace ndframe
{
namespace
{

constexpr const char *red = "\x1b[31m", *yellow = "\x1b[33m", *plain = "\x1b[0m";

/// A failure that the other ranks may know nothing of: the rank that has it prints it, and all processes end.
ExitCode failAlone(const Comm& comm, ExitCode code, std::string_view text)
{
  transcribe(std::string(text));
  std::cerr << text << std::endl;
  comm.abort(int(code));
  return code;
}

/// Ends the process at once: at a normal exit OpenBLAS waits for its threads, which may ask for memory for ever.
[[noreturn]] void failForMemory(const Comm& comm)
{
  const auto code = failAlone(comm, ExitCode::UserInput, needsMoreMemory);
  std::cout.flush();
  std::_Exit(int(code));
}

} // namespace

ExitCode codeOf(const Run& run)
{
  const auto& accuracy = run.summary.accuracy;
  const auto& expectations = run.summary.expectations;
  if (!run.bug.empty())
    return ExitCode::Bug;
  if (!run.failure.empty())
    return ExitCode::NotConverged;
  if (accuracy && !accuracy->reached)
    return ExitCode::TargetMissed;
  const bool met = std::all_of(expectations.begin(), expectations.end(), [](const auto& e) { return e.met; });
  if (!met)
    return ExitCode::ExpectationMissed;
  return run.strictInput && !run.summary.warnings.empty() ? ExitCode::Warned : ExitCode::Right;
}

ExitCode report(const Failure& failure, bool computed, const Comm& comm)
{
  if (failure.outOfMemory)
    failForMemory(comm);
  if (failure.code == ExitCode::Bug)
    return failAlone(comm, failure.code, failure.text);
  complain(comm, failure.text);
  if (failure.mistakes > 0)
    complain(comm, fmt::format("{} error{}; {}", failure.mistakes, failure.mistakes == 1 ? "" : "s",
                               computed ? "the results could not be written." : "nothing was computed."));
  return failure.code;
}

void complain(const Comm& comm, const std::string& text)
{
  if (comm.rank() != 0)
    return;
  transcribe(text);
  if (mayDraw(STDERR_FILENO, comm))
    std::cerr << (text.rfind("warning", 0) == 0 ? yellow : red) << text << plain << std::endl;
  else
    std::cerr << text << std::endl;
}

} // namespace ndframe

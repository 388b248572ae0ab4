#include "screen_files.hpp"

#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string_view>

#include <fmt/format.h>

#include "ndframe/algebra/launcher.hpp"
#include "ndframe/live/transcript.hpp"
#include "ndframe/report/outputs.hpp"
#include "ndframe/run/summarize.hpp"
#include "signals.hpp"

namespace ndframe
{
namespace
{

/// Says what was lost of the output.
ExitCode lost(ExitCode code, std::string_view what)
{
  std::cerr << what << std::endl;
  return code == ExitCode::Right ? ExitCode::UserInput : code;
}

} // namespace

bool mayDraw(int stream, const Comm& comm)
{
  const char *const noColour = std::getenv("NO_COLOR"), *const terminal = std::getenv("TERM");
  const bool isPlain =
      (noColour != nullptr && *noColour != '\0') || terminal == nullptr || std::string_view(terminal) == "dumb";
  return comm.size() == 1 && !launcherOfThisProcess().present && !isPlain && isatty(stream) != 0;
}

std::optional<std::chrono::milliseconds> patienceOf(const CommandLine& options)
{
  if (!options.live)
    return std::nullopt;
  constexpr double perSecond = 1e3;
  return std::chrono::milliseconds(std::int64_t(std::ceil(perSecond * *options.live)));
}

void beginTranscript(const CommandLine& options, const Comm& comm)
{
  if (options.logFile.empty())
    return;
  writeOnFirstRank(comm, [&] {
    std::error_code ignored;
    if (std::filesystem::equivalent(options.logFile, options.deck, ignored))
      throw InputError(fmt::format("--log: \"{}\" is the deck; give the log another name.", options.logFile));
    const std::string title = fmt::format("ndframe {} {}", versionText(), options.deck);
    if (const std::string reason = openTranscript(options.logFile, title); !reason.empty())
      throw InputError(fmt::format("--log: cannot write \"{}\": {}.", options.logFile, reason));
  });
}

ExitCode checkScreen(ExitCode code, const Comm& comm)
{
  const char* const reason = lostOutput();
  if (reason != nullptr && comm.rank() == 0)
    code = lost(code, fmt::format("cannot write to the standard output: {}", reason));
  if (const std::string file = closeTranscript(); !file.empty())
    code = lost(code, file);
  return code;
}

} // namespace ndframe

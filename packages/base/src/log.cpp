#include "ndframe/base/log.hpp"

#include "ndframe/live/live_line.hpp"
#include "ndframe/live/transcript.hpp"

namespace ndframe
{

Log::Log(std::ostream& stream, Verbosity verbosity, bool speaks, bool terminal,
         std::optional<std::chrono::milliseconds> patience)
    : stream_(stream), verbosity_(verbosity), speaks_(speaks)
{
  const auto wait = patience.value_or(std::chrono::seconds(terminal ? 1 : 10));
  if (speaks && verbosity != Verbosity::Quiet && wait.count() > 0)
    live_ = std::make_unique<LiveLine>(stream, terminal, wait);
}

Log::~Log() = default;

void Log::print(const std::string& text) const
{
  if (!speaks_)
    return;
  transcribe(text);
  if (live_)
    live_->print(text);
  else if (verbosity_ != Verbosity::Quiet)
    stream_ << text << '\n' << std::flush;
}

void Log::line(const std::string& text) const
{
  print(text);
}

void Log::detail(const std::string& text) const
{
  if (verbosity_ == Verbosity::Verbose)
    print(text);
}

void Log::beginStage(const std::string& stage) const
{
  if (!speaks_)
    return;
  transcribeStage(stage);
  if (live_)
    live_->beginStage(stage);
}

void Log::endStage(const std::string& stage) const
{
  if (live_)
    live_->endStage(stage);
}

void Log::tell(Depth depth, const Progress& progress) const
{
  if (live_)
    live_->tell(depth, progress);
}

const Log& silentLog()
{
  static std::ostream nowhere(nullptr);
  static const Log log(nowhere, Verbosity::Quiet, false, false);
  return log;
}

} // namespace ndframe

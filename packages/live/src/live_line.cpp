#include "ndframe/live/live_line.hpp"

#include <algorithm>

#include <sys/ioctl.h>
#include <unistd.h>

#include <fmt/format.h>

namespace ndframe
{
namespace
{

constexpr const char *dim = "\x1b[2m", *plain = "\x1b[0m", *eraseLine = "\r\x1b[K";

/// Of the terminal that this process writes to: a line that it would break could not be erased.
std::size_t columns()
{
  winsize size{};
  const bool known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

} // namespace

LiveLine::LiveLine(std::ostream& stream, bool terminal, std::chrono::milliseconds patience)
    : stream_(stream), terminal_(terminal), patience_(patience), drawAt_(Clock::now() + patience),
      thread_([this] { run(); })
{}

LiveLine::~LiveLine()
{
  {
    const std::lock_guard lock(mutex_);
    erase();
    quit_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void LiveLine::beginStage(const std::string& stage)
{
  {
    const std::lock_guard lock(mutex_);
    erase();
    state_.beginStage(stage);
  }
  changed_.notify_one();
}

void LiveLine::endStage(const std::string& stage)
{
  const std::lock_guard lock(mutex_);
  erase();
  state_.endStage(stage);
}

void LiveLine::tell(Depth depth, const Progress& progress)
{
  const std::lock_guard lock(mutex_);
  state_.tell(depth, progress, seconds());
}

void LiveLine::print(const std::string& text)
{
  const std::lock_guard lock(mutex_);
  erase();
  stream_ << text << '\n' << std::flush;
  drawAt_ = Clock::now() + patience_;
}

void LiveLine::run()
{
  std::unique_lock lock(mutex_);
  while (!quit_) {
    if (state_.isEmpty())
      changed_.wait(lock);
    else if (Clock::now() < drawAt_)
      changed_.wait_until(lock, Clock::time_point(drawAt_));
    else
      draw();
  }
}

void LiveLine::draw()
{
  std::string line = fmt::format("  {} ... {:.0f} s", state_.text(seconds()), seconds());
  if (terminal_) {
    line.resize(std::min(line.size(), columns() - 1));
    stream_ << (drawn_ ? eraseLine : "") << dim << line << plain;
  } else {
    stream_ << line << '\n';
  }
  stream_ << std::flush;
  drawn_ = terminal_;
  drawAt_ = Clock::now() + (terminal_ ? patience_ / 4 : patience_);
}

void LiveLine::erase()
{
  if (drawn_)
    stream_ << eraseLine << std::flush;
  drawn_ = false;
}

double LiveLine::seconds() const
{
  return std::chrono::duration<double>(Clock::now() - begin_).count();
}

} // namespace ndframe

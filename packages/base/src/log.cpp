#include "ndframe/base/log.hpp"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace ndframe
{

/// The live line: a thread that waits for the stage to last a second, then draws. Every write to the stream goes
/// through here, so that a line never lands in the middle of the drawn one.
class Log::Live
{
public:
  explicit Live(std::ostream& stream) : stream_(stream), thread_([this] { run(); }) {}

  ~Live()
  {
    stop();
    {
      const std::lock_guard lock(mutex_);
      quit_ = true;
    }
    changed_.notify_one();
    thread_.join();
  }

  void start(const std::string& what)
  {
    const std::lock_guard lock(mutex_);
    erase();
    what_ = what;
    drawAt_ = Clock::now() + std::chrono::seconds(1);
    changed_.notify_one();
  }

  void stop()
  {
    const std::lock_guard lock(mutex_);
    erase();
    what_.clear();
  }

  void print(const std::string& text)
  {
    const std::lock_guard lock(mutex_);
    erase();
    stream_ << text << '\n' << std::flush;
    drawAt_ = Clock::now() + std::chrono::seconds(1);
  }

private:
  using Clock = std::chrono::steady_clock;

  void run()
  {
    std::unique_lock lock(mutex_);
    while (!quit_) {
      if (what_.empty() || drawn_)
        changed_.wait(lock);
      else if (Clock::now() < drawAt_)
        changed_.wait_until(lock, Clock::time_point(drawAt_));
      else
        draw();
    }
  }

  void draw()
  {
    stream_ << "  " << what_ << " ..." << std::flush;
    drawn_ = true;
  }

  void erase()
  {
    if (drawn_)
      stream_ << "\r\x1b[K" << std::flush;
    drawn_ = false;
    changed_.notify_one();
  }

  std::ostream& stream_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::string what_; ///< empty: nothing to show
  Clock::time_point drawAt_;
  bool drawn_ = false;
  bool quit_ = false;
  std::thread thread_; ///< last: it uses all of the above
};

Log::Log(std::ostream& stream, Verbosity verbosity, bool speaks, bool terminal)
    : stream_(stream), verbosity_(verbosity), speaks_(speaks)
{
  if (terminal && speaks && verbosity != Verbosity::Quiet)
    live_ = std::make_unique<Live>(stream);
}

Log::~Log() = default;

void Log::print(const std::string& text) const
{
  if (!speaks_)
    return;
  if (live_)
    live_->print(text);
  else
    stream_ << text << '\n' << std::flush;
}

void Log::line(const std::string& text) const
{
  if (verbosity_ != Verbosity::Quiet)
    print(text);
}

void Log::detail(const std::string& text) const
{
  if (verbosity_ == Verbosity::Verbose)
    print(text);
}

void Log::startLive(const std::string& what) const
{
  if (live_)
    live_->start(what);
}

void Log::stopLive() const
{
  if (live_)
    live_->stop();
}

const Log& silentLog()
{
  static std::ostream nowhere(nullptr);
  static const Log log(nowhere, Verbosity::Quiet, false, false);
  return log;
}

} // namespace ndframe

#include "ndframe/base/log.hpp"

#include <condition_variable>
#include <mutex>
#include <thread>

namespace ndframe
{

/// Signs of life: a thread that waits for the stage to last, then writes. Every write to the stream goes through here,
/// so that a line never lands in the middle of another.
class Log::Live
{
public:
  Live(std::ostream& stream, bool erases, std::chrono::milliseconds patience)
      : stream_(stream), erases_(erases), patience_(patience), thread_([this] { run(); })
  {}

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
    wait();
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
    wait();
  }

private:
  using Clock = std::chrono::steady_clock;

  /// From now on, as long as at first.
  void wait()
  {
    since_ = Clock::now();
    drawAt_ = since_ + patience_;
    changed_.notify_one();
  }

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
    stream_ << "  " << what_ << " ...";
    if (!erases_) {
      const auto silent = Clock::now() - since_;
      stream_ << ' ' << std::chrono::duration_cast<std::chrono::seconds>(silent).count() << " s\n";
      drawAt_ += silent;
    }
    stream_ << std::flush;
    drawn_ = erases_;
  }

  void erase()
  {
    if (drawn_)
      stream_ << "\r\x1b[K" << std::flush;
    drawn_ = false;
    changed_.notify_one();
  }

  std::ostream& stream_;
  const bool erases_; ///< a terminal
  const std::chrono::milliseconds patience_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::string what_; ///< empty: nothing to show
  Clock::time_point since_, drawAt_;
  bool drawn_ = false;
  bool quit_ = false;
  std::thread thread_; ///< last: it uses all of the above
};

Log::Log(std::ostream& stream, Verbosity verbosity, bool speaks, bool terminal, std::chrono::milliseconds patience)
    : stream_(stream), verbosity_(verbosity), speaks_(speaks)
{
  if (speaks && verbosity != Verbosity::Quiet)
    live_ = std::make_unique<Live>(stream, terminal, terminal ? std::chrono::seconds(1) : patience);
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

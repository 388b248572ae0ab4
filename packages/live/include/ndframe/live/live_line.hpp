#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <ostream>
#include <string>
#include <thread>

#include "ndframe/live/progress_state.hpp"

namespace ndframe
{

/// Signs of life: a thread that waits for `patience` without a printed line, then writes what goes on. A terminal's
/// line is drawn again every quarter of it, and erased before anything else is printed and when a stage ends; a pipe
/// gets one line after each `patience`. Every write to the stream goes through here, so that a line never lands in the
/// middle of another.
class LiveLine
{
public:
  /// Starts the thread. The stream must live as long. terminal: it can erase a line. patience: above zero.
  LiveLine(std::ostream& stream, bool terminal, std::chrono::milliseconds patience);
  ~LiveLine();
  LiveLine(const LiveLine&) = delete;
  LiveLine& operator=(const LiveLine&) = delete;

  void beginStage(const std::string& stage);        ///< as ProgressState::beginStage
  void endStage(const std::string& stage);          ///< as ProgressState::endStage
  void tell(Depth depth, const Progress& progress); ///< shown with the next drawing
  void print(const std::string& text);              ///< with a newline behind it; patience begins again

private:
  using Clock = std::chrono::steady_clock;

  void run();
  void draw();
  void erase();
  double seconds() const;

  std::ostream& stream_;
  const bool terminal_;
  const std::chrono::milliseconds patience_;
  const Clock::time_point begin_ = Clock::now();
  std::mutex mutex_;
  std::condition_variable changed_;
  ProgressState state_;
  Clock::time_point drawAt_; ///< not before
  bool drawn_ = false;
  bool quit_ = false;
  std::thread thread_; ///< last: it uses all of the above
};

} // namespace ndframe

#pragma once

#include <chrono>
#include <memory>
#include <ostream>
#include <string>

namespace ndframe
{

enum class Verbosity
{
  Quiet,
  Normal,
  Verbose
};

/// The screen. Only the rank that is told to speaks. No state other than the live line of a terminal.
class Log
{
public:
  /// `terminal`: the stream is a terminal, so a live line may be drawn (and erased) on it. `patience`: how long a stage
  /// is silent on anything else before a line says that it goes on.
  Log(std::ostream& stream, Verbosity verbosity, bool speaks, bool terminal,
      std::chrono::milliseconds patience = std::chrono::seconds(10));
  ~Log();
  Log(const Log&) = delete;
  Log& operator=(const Log&) = delete;

  /// Header, sweeps, tables: everything a normal run prints. `text` is one or several lines without the last newline.
  void line(const std::string& text) const;
  /// Details, only with -v.
  void detail(const std::string& text) const;

  /// Until stopLive(): draws "  <what> ..." on a terminal once a second has passed; on a pipe or in a file one line
  /// "  <what> ... 10 s" after each 10, 20, 40, ... s without any other.
  void startLive(const std::string& what) const;
  void stopLive() const;

private:
  class Live;
  void print(const std::string& text) const;

  std::ostream& stream_;
  Verbosity verbosity_;
  bool speaks_;
  std::unique_ptr<Live> live_; ///< null if nothing is to be said
};

/// A sink for tests and library use.
const Log& silentLog();

} // namespace ndframe

#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <ostream>
#include <string>

#include "ndframe/live/progress_state.hpp"

namespace ndframe
{

/// How much is shown: warnings and errors only (-q), the run, and what solvers tell (-v).
enum class Verbosity
{
  Quiet,
  Normal,
  Verbose
};

class LiveLine;

/// The screen, and the file of --log (transcript.hpp). Only the rank that is told to speaks. No state other than the
/// live line of a terminal.
class Log
{
public:
  /// `terminal`: the stream is a terminal, so a live line may be drawn (and erased) on it. `patience`: how long it may
  /// be silent before a line says what goes on, 1 s on a terminal and 10 s elsewhere without it; 0: for ever.
  Log(std::ostream& stream, Verbosity verbosity, bool speaks, bool terminal,
      std::optional<std::chrono::milliseconds> patience = {});
  ~Log();
  Log(const Log&) = delete;
  Log& operator=(const Log&) = delete;

  /// Header, sweeps, tables: everything a normal run prints. `text` is one or several lines without the last newline.
  /// With Quiet only the file gets it.
  void line(const std::string& text) const;
  /// Details, only with -v.
  void detail(const std::string& text) const;

  /// Until endStage(), a live line "  <stage>, <how far> ... 12 s" may be shown (live_line.hpp); the seconds are those
  /// of this log.
  void beginStage(const std::string& stage) const;
  void endStage(const std::string& stage) const; ///< ends the live line of the stage
  /// How far something is, for the live line.
  void tell(Depth depth, const Progress& progress) const;

private:
  void print(const std::string& text) const;

  std::ostream& stream_;
  Verbosity verbosity_;
  bool speaks_;
  std::unique_ptr<LiveLine> live_; ///< null if nothing is to be said
};

/// A sink for tests and library use.
const Log& silentLog();

} // namespace ndframe

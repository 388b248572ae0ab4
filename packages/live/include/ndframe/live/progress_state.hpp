#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ndframe
{

/// What may go on inside what, the outermost first. A stage ends the steps, passes and iterations in it.
enum class Depth
{
  Case,
  Level,
  Body,
  Step,
  Pass,
  Iteration
};

/// How far something that goes step by step is. Names are literals: they are not copied.
struct Progress
{
  const char* name;       ///< "sweep"
  std::int64_t number;    ///< of the present or last one, from 1
  std::int64_t of = 0;    ///< how many there are; 0: not known
  double share = -1.0;    ///< of all the work that is done, in [0, 1]; negative: not known
  const char* value = ""; ///< what falls, "residual"
  double now = 0.0;       ///< and how large it is
  double goal = 0.0;      ///< it ends below; 0: not known

  /// One of `of`; share: of the work, done.
  static Progress part(const char* name, std::int64_t number, std::int64_t of, double share);
  /// One of who knows how many, until `now` is below `goal`.
  static Progress falling(const char* name, std::int64_t number, const char* value, double now, double goal);
};

/// What goes on and how far it is, as one line of text. Times are seconds since any origin, the same for all calls.
///
/// What is left is guessed from what was done since the first call: work in equal parts takes equal times, and values
/// fall by the same factor in equal times. Nothing is said where that means nothing (a first call, a value that grows).
class ProgressState
{
public:
  /// Threads may have stages of their own at once; the one that began last is shown.
  void beginStage(const std::string& stage);
  void endStage(const std::string& stage); ///< the one of this name that began last; ends steps in it, too
  /// Ends what goes on inside; the last of its parts ends it, too.
  void tell(Depth depth, const Progress& progress, double seconds);

  bool isEmpty() const { return stages_.empty(); } ///< no stage goes on
  /// "level 3, bound 0.02 (until 0.01), couple, sweep 4, eps_tau 0.1 (until 0.01, about 3 s left)"; without a stage
  /// empty.
  std::string text(double seconds) const;

private:
  /// What was told of one depth.
  struct Told
  {
    Progress first, last;
    double begin, seconds;
    std::optional<double> left(double now) const;
    std::string text(double now) const;
  };

  void endInside(std::size_t depth);

  std::vector<std::string> stages_;         ///< that have begun and not ended
  std::array<std::optional<Told>, 6> told_; ///< by depth
};

} // namespace ndframe

#include "ndframe/live/progress_state.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

namespace ndframe
{
namespace
{

constexpr auto firstInStage = std::size_t(Depth::Step);

/// Guesses have one digit or two.
std::string duration(double seconds)
{
  constexpr double minute = 60.0, hour = 3600.0;
  if (seconds < 2.0 * minute)
    return fmt::format("{:.0f} s", seconds);
  return seconds < 2.0 * hour ? fmt::format("{:.0f} min", seconds / minute) : fmt::format("{:.1f} h", seconds / hour);
}

/// Of the work since the first call, in the time that it took; none where there is none.
std::optional<double> remaining(const Progress& first, const Progress& last, double took)
{
  if (first.share >= 0.0 && last.share > first.share)
    return took * (1.0 - last.share) / (last.share - first.share);
  const bool falls = last.goal > 0.0 && last.now > 0.0 && last.now < first.now;
  if (falls)
    return took * std::max(0.0, std::log(last.now / last.goal) / std::log(first.now / last.now));
  return std::nullopt;
}

} // namespace

Progress Progress::part(const char* name, std::int64_t number, std::int64_t of, double share)
{
  return {name, number, of, share};
}

Progress Progress::falling(const char* name, std::int64_t number, const char* value, double now, double goal)
{
  return {name, number, 0, -1.0, value, now, goal};
}

std::optional<double> ProgressState::Told::left(double now) const
{
  auto guess = remaining(first, last, seconds - begin);
  if (guess)
    guess = std::max(0.0, *guess - (now - seconds));
  return guess;
}

std::string ProgressState::Told::text(double now) const
{
  std::string text = fmt::format("{} {}", last.name, last.number);
  if (last.of > 0)
    text += fmt::format(" of {}", last.of);
  if (last.share >= 0.0)
    text += fmt::format(", {:.0f} %", 100.0 * last.share);
  if (last.now > 0.0)
    text += fmt::format(", {} {:.2g}", last.value, last.now);
  std::string more;
  if (last.goal > 0.0)
    more = fmt::format("until {:.2g}", last.goal);
  if (const auto guess = left(now))
    more += fmt::format("{}about {} left", more.empty() ? "" : ", ", duration(*guess));
  return more.empty() ? text : fmt::format("{} ({})", text, more);
}

void ProgressState::endInside(std::size_t depth)
{
  std::fill(told_.begin() + std::ptrdiff_t(depth), told_.end(), std::nullopt);
}

void ProgressState::beginStage(const std::string& stage)
{
  stages_.push_back(stage);
  endInside(firstInStage);
}

void ProgressState::endStage(const std::string& stage)
{
  const auto ended = std::find(stages_.rbegin(), stages_.rend(), stage);
  if (ended != stages_.rend())
    stages_.erase(std::next(ended).base());
  endInside(firstInStage);
}

void ProgressState::tell(Depth depth, const Progress& progress, double seconds)
{
  endInside(std::size_t(depth) + 1);
  auto& told = told_.at(std::size_t(depth));
  const bool goesOn =
      told && std::string_view(told->last.name) == progress.name && told->last.number <= progress.number;
  if (goesOn) {
    told->last = progress;
    told->seconds = seconds;
  } else {
    told = Told{progress, progress, seconds, seconds};
  }
  if (progress.share >= 1.0)
    told.reset();
}

std::string ProgressState::text(double seconds) const
{
  if (isEmpty())
    return {};
  std::string text;
  for (std::size_t depth = 0; depth < told_.size(); ++depth) {
    if (depth == std::size_t(Depth::Body))
      text += (text.empty() ? "" : ", ") + stages_.back();
    if (told_.at(depth))
      text += (text.empty() ? "" : ", ") + told_.at(depth)->text(seconds);
  }
  return text;
}

} // namespace ndframe

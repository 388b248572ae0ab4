#include "ndframe/report/accuracy_screen.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ndframe/base/grouped.hpp"
#include "ndframe/report/screen.hpp"

namespace ndframe
{
namespace
{

/// What the target is and how near the last level came, in the same words.
std::string amount(const AccuracySummary& summary, double absolute, double relative)
{
  return summary.relative ? fmt::format("{:.3g} %", 100.0 * relative) : fmt::format("{:.4g}", absolute);
}

/// A bound above the size of the solution says nothing of its size; nor do predictions from there.
constexpr double meaningless = 1.0;

std::string relativeText(const LevelSummary& level)
{
  return level.relative > meaningless ? " > 100 %" : fmt::format("{:>6.3g} %", 100.0 * level.relative);
}

} // namespace

std::string levelTitle(const AccuracySummary& summary, bool replacesTolerance)
{
  const char* const stopping = replacesTolerance ? "\n  stopping: by the balance with the mesh, not by Tolerance" : "";
  return fmt::format("  target {} ({}){}\n\n  level      dofs  sweeps       bound                mesh   iteration   "
                     "dofs to target   seconds   shape   largest contribution",
                     amount(summary, summary.target, summary.target),
                     summary.of == "Displacement" ? "displacement" : "mean stress", stopping);
}

std::string levelLine(const LevelSummary& level, const std::string& note)
{
  return fmt::format(
      "  {:>5} {:>9}  {:>6}  {:>10.4g}  {}  {:>10.4g}  {:>10.2e}   {:>14}   {:>7.3f}   {:>5.2f}   {:.3g} in {}{}{}",
      level.level, grouped(level.dofs), level.sweeps, level.bound, relativeText(level), level.mesh, level.iteration,
      level.dofsToTarget > 0 ? grouped(level.dofsToTarget) : "-", level.seconds, level.worstShape,
      fmt::join(level.worstPoint, ", "), level.worstBody, level.doubt.empty() ? "" : "   not guaranteed",
      note.empty() ? "" : "   note: " + note);
}

std::string accuracyText(const AccuracySummary& summary, bool guaranteed)
{
  if (summary.levels.empty())
    return fmt::format("target {} NOT reached: no level was finished; limit: {}",
                       amount(summary, summary.target, summary.target), summary.limit);
  const LevelSummary& answer = summary.answer();
  return fmt::format("target {} {}: {} {}, {} dofs, {} level{}, {} sweeps, {:.2f} s{}",
                     amount(summary, summary.target, summary.target), summary.reached ? "reached" : "NOT reached",
                     amount(summary, answer.bound, answer.relative), guaranteed ? "guaranteed" : "not guaranteed",
                     grouped(answer.dofs), summary.levels.size(), summary.levels.size() == 1 ? "" : "s",
                     summary.sweeps(), summary.levels.back().seconds,
                     summary.reached ? std::string() : "; limit: " + summary.limit);
}

std::string missedTarget(const RunSummary& summary)
{
  if (!summary.accuracy || !summary.errors || summary.accuracy->reached || summary.accuracy->levels.empty())
    return {};
  const AccuracySummary& accuracy = *summary.accuracy;
  const LevelSummary& answer = accuracy.answer();
  return fmt::format("target {} missed: {}; {} {}", amount(accuracy, accuracy.target, accuracy.target), accuracy.limit,
                     summary.errors->guaranteed ? "the answer is guaranteed to" : "its error, not guaranteed, is",
                     amount(accuracy, answer.bound, answer.relative));
}

} // namespace ndframe

#include "ndframe/report/summary_text.hpp"

#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ndframe/io/csv.hpp"
#include "summary_json.hpp"

// docs/summary.schema.json describes what is written here; tests/report holds the two together.

namespace ndframe
{
namespace
{

Json levelJson(const LevelSummary& level)
{
  return {{"level", level.level},
          {"dofs", level.dofs},
          {"elements", level.elements},
          {"worst_shape", level.worstShape},
          {"sweeps", level.sweeps},
          {"bound", level.bound},
          {"relative", level.relative},
          {"mesh", level.mesh},
          {"iteration", level.iteration},
          {"largest", {{"body", level.worstBody}, {"point", level.worstPoint}}},
          {"dofs_to_target", level.dofsToTarget > 0 ? Json(level.dofsToTarget) : Json()},
          {"seconds", level.seconds},
          {"energy_bracket", bracketOrNull(level.energy)},
          {"guaranteed", level.doubt.empty()},
          {"reason", level.doubt}};
}

} // namespace

Json accuracyJson(const std::optional<AccuracySummary>& accuracy)
{
  if (!accuracy)
    return nullptr;
  auto levels = Json::array();
  for (const auto& level : accuracy->levels)
    levels.push_back(levelJson(level));
  return {{"of", accuracy->of},
          {"target", accuracy->target},
          {"relative", accuracy->relative},
          {"reached", accuracy->reached},
          {"limit", accuracy->limit},
          {"number_of_levels", accuracy->levels.size()},
          {"sweeps", accuracy->sweeps()},
          {"level", accuracy->written},
          {"dofs", accuracy->written == 0 ? 0 : accuracy->answer().dofs},
          {"total_dofs", accuracy->totalDofs()},
          {"levels", std::move(levels)}};
}

std::string levelsCsv(const std::vector<LevelSummary>& levels)
{
  fmt::memory_buffer buffer;
  auto out = std::back_inserter(buffer);
  const bool plane = levels.empty() || levels.front().worstPoint.size() == 2;
  fmt::format_to(
      out,
      "level,dofs,elements,worst_shape,sweeps,bound,relative,mesh,iteration,largest_body,largest_x,largest_y,"
      "{}dofs_to_target,seconds,energy_lower,energy_upper,guaranteed\n",
      plane ? "" : "largest_z,");
  for (const auto& level : levels) {
    fmt::format_to(out, "{},{},{},{:.17g},{},{:.17g},{:.17g},{:.17g},{:.17g},", level.level, level.dofs, level.elements,
                   level.worstShape, level.sweeps, level.bound, level.relative, level.mesh, level.iteration);
    fmt::format_to(out, "{},{:.17g},{},{:.6f},", csvField(level.worstBody), fmt::join(level.worstPoint, ","),
                   level.dofsToTarget > 0 ? fmt::format("{}", level.dofsToTarget) : "", level.seconds);
    fmt::format_to(out, "{},{:d}\n",
                   level.energy ? fmt::format("{:.17g},{:.17g}", level.energy->lower, level.energy->upper) : ",",
                   int(level.doubt.empty()));
  }
  return fmt::to_string(buffer);
}

} // namespace ndframe

#include "accuracy_limits.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace ndframe
{
namespace
{

/// A bound that falls by less than this, in two levels that make meshes so much larger, or in so many levels at most,
/// does not follow the mesh any more. On a mesh with a few cells more it may rise: contact ends at another place.
constexpr double stalled = 0.98, larger = 2.0;
constexpr std::size_t mostLevels = 6;
/// Relative bounds below this may be nothing but round-off of the residuals, which stays when cells become smaller.
constexpr double roundOff = 1e-8;

bool isStalled(const std::vector<LevelSummary>& levels)
{
  std::size_t back = 2;
  while (back < mostLevels && back < levels.size() &&
         double(levels.back().dofs) < larger * double(levels[levels.size() - 1 - back].dofs))
    ++back;
  return back < levels.size() && levels.back().bound > stalled * levels[levels.size() - 1 - back].bound;
}

bool isWithinTarget(const AccuracyOptions& options, const LevelSummary& level)
{
  return (options.relative ? level.relative : level.bound) <= options.target;
}

} // namespace

bool isBetter(const LevelSummary& level, const LevelSummary& other)
{
  return std::pair(!level.doubt.empty(), level.bound) < std::pair(!other.doubt.empty(), other.bound);
}

bool lostGuarantee(const std::vector<LevelSummary>& levels)
{
  const auto isGuaranteed = [](const LevelSummary& level) { return level.doubt.empty(); };
  return !isGuaranteed(levels.back()) && std::any_of(levels.begin(), levels.end(), isGuaranteed);
}

std::string endOfProgress(const AccuracyOptions& options, const std::vector<LevelSummary>& levels,
                          const CouplingResult& coupling)
{
  if (!coupling.converged && !coupling.history.empty())
    return fmt::format("the sweeps do not converge ({})", coupling.reason);
  if (lostGuarantee(levels) && isWithinTarget(options, levels.back()))
    return fmt::format("level {} reaches it without a guarantee: {}", levels.size(), levels.back().doubt);
  if (int(levels.size()) >= options.maximumLevels)
    return fmt::format("Maximum Levels = {}", options.maximumLevels);
  if (isStalled(levels))
    return levels.back().relative < roundOff ? "the bound no longer falls with the mesh: round-off"
                                             : "the bound no longer falls with the mesh";
  return {};
}

std::string limitMet(const AccuracyOptions& options, const std::vector<LevelSummary>& levels, std::int64_t nextDofs,
                     double memory)
{
  const LevelSummary& present = levels.back();
  const double growth = double(nextDofs) / double(present.dofs);
  if (nextDofs > options.maximumDofs)
    return fmt::format("Maximum Dofs = {}", options.maximumDofs);
  const double last = present.seconds - (levels.size() > 1 ? levels[levels.size() - 2].seconds : 0.0);
  if (present.seconds + growth * last > options.maximumSeconds)
    return fmt::format("Maximum Time = {:g} s: the next mesh would take {:.2g} s", options.maximumSeconds,
                       growth * last);
  if (memory > options.maximumMemory)
    return fmt::format("Maximum Memory = {:g} GB: with the next mesh it would be about {:.3g} GB",
                       options.maximumMemory * 1e-9, memory * 1e-9);
  return {};
}

} // namespace ndframe

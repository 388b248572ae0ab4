#include "ndframe/equilibrium/element_circulation.hpp"

#include <algorithm>

namespace ndframe
{
namespace
{

/// Directions closer than this (sine of the angle) are one: half of the digits for the known values, half for the
/// flows.
constexpr double parallel = 1e-8;

/// A force of which some components are known.
class PartlyKnown
{
public:
  /// One more component. One that follows from those before is not used; the contradiction is returned.
  double add(Circulation::Known known)
  {
    for (int k = 0; k < count_; ++k) {
      const double along = dot(known.direction, known_[k].direction);
      known.direction = known.direction - along * known_[k].direction;
      known.value -= along * known_[k].value;
    }
    const double length = norm(known.direction);
    if (length < parallel)
      return std::abs(known.value);
    known_[count_++] = {1.0 / length * known.direction, known.value / length};
    return 0.0;
  }
  /// `wish` with the known components as they are.
  Force nearest(Force wish) const
  {
    for (int k = 0; k < count_; ++k)
      wish = wish + (known_[k].value - dot(wish, known_[k].direction)) * known_[k].direction;
    return wish;
  }

private:
  int count_ = 0;
  Circulation::Known known_[2] = {};
};

} // namespace

Flows leastFlows(const Circulation& problem)
{
  Flows flows;
  Force all;
  for (const Force step : problem.steps)
    all = all + step;
  const Force closing = problem.closed ? -1.0 / double(problem.steps.size()) * all : Force{};
  flows.flow.emplace_back();
  for (const Force step : problem.steps)
    flows.flow.push_back(flows.flow.back() + step + closing);

  Force weighted;
  double weights = 0.0;
  for (std::size_t k = 0; k < problem.weights.size(); ++k) {
    weighted = weighted + problem.weights[k] * flows.flow[k];
    weights += problem.weights[k];
  }
  PartlyKnown first;
  flows.defect = problem.closed ? norm(all) : 0.0;
  for (const auto& known : problem.atFirst)
    flows.defect = std::max(flows.defect, first.add(known));
  for (const auto& [direction, value] : problem.atLast)
    flows.defect = std::max(flows.defect, first.add({direction, value - dot(direction, flows.flow.back())}));
  const Force start = first.nearest(-1.0 / weights * weighted);
  for (Force& flow : flows.flow)
    flow = flow + start;
  return flows;
}

} // namespace ndframe

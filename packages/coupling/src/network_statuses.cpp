#include "network_statuses.hpp"

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

constexpr int mostPasses = 20;

/// One pass; false where loads do work on motions that the set leaves free.
bool balances(FetiProblem& forces, const std::vector<char>& closed, StatusPass& pass)
{
  const bool held = forces.holds(closed);
  try {
    forces.solve(closed, held ? 0.0 : forces.proximalLimits().weight, pass);
  } catch (const NotPositiveDefinite&) {
    return false;
  }
  return held || pass.unbalanced <= pass.roundOff * pass.load;
}

} // namespace

void sharpen(FetiProblem& forces, double tolerance, const Network& network, SettledNetwork& settled)
{
  const std::vector<char> constrained(network.bound.size(), 1);
  std::vector<char> closed = settled.status.closed;
  forces.endAt(tolerance);
  StatusPass pass;
  for (int number = 1; number <= mostPasses && balances(forces, closed, pass); ++number) {
    const std::vector<int> wrong = violations(pass, constrained, network.bound, closed);
    if (wrong.empty()) {
      settled.status.passes += number;
      settled.status.u = pass.u;
      settled.status.force = pass.force;
      settled.status.closed = closed;
      settled.v = forces.displacement();
      return;
    }
    for (const int i : wrong)
      closed[std::size_t(i)] = !closed[std::size_t(i)];
  }
}

} // namespace ndframe

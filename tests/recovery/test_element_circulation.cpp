#include <gtest/gtest.h>

#include "fem/sample_meshes.hpp"
#include "ndframe/equilibrium/element_circulation.hpp"

namespace ndframe
{
namespace
{

constexpr double roundOff = 1e-13;

Force randomForce(test::Random& random)
{
  return {random(), random()};
}

Force direction(double degrees)
{
  const double angle = degrees * M_PI / 180.0;
  return {std::cos(angle), std::sin(angle)};
}

/// Steps that add up to nothing where the fan is closed; no component known.
Circulation randomFan(int cells, bool closed, unsigned seed)
{
  test::Random random(seed);
  Circulation problem;
  problem.closed = closed;
  Force rest;
  for (int k = 0; k < cells; ++k) {
    problem.steps.push_back(randomForce(random));
    rest = rest - problem.steps.back();
  }
  if (closed)
    problem.steps.back() = problem.steps.back() + rest;
  for (int k = 0; k < cells + (closed ? 0 : 1); ++k)
    problem.weights.push_back(random(0.5, 2.0));
  return problem;
}

void expectStepsAreKept(const Circulation& problem, const Flows& flows)
{
  ASSERT_EQ(flows.flow.size(), problem.steps.size() + 1);
  for (std::size_t k = 0; k < problem.steps.size(); ++k)
    EXPECT_LT(norm(flows.flow[k + 1] - flows.flow[k] - problem.steps[k]), roundOff);
  if (problem.closed) {
    EXPECT_LT(norm(flows.flow.back() - flows.flow.front()), roundOff);
  }
}

/// Derivative of the weighted squares with respect to what goes through all edges.
Force slope(const Circulation& problem, const Flows& flows)
{
  Force sum;
  for (std::size_t k = 0; k < problem.weights.size(); ++k)
    sum = sum + problem.weights[k] * flows.flow[k];
  return sum;
}

} // namespace

TEST(Circulation, ThatIsFreeHasTheLeastWeightedFlows)
{
  for (const bool closed : {true, false})
    for (const int cells : {1, 3, 7}) {
      const auto problem = randomFan(cells, closed, 3);
      const auto flows = leastFlows(problem);
      expectStepsAreKept(problem, flows);
      EXPECT_LT(norm(slope(problem, flows)), roundOff);
      EXPECT_LT(flows.defect, roundOff);
    }
}

TEST(Circulation, KeepsAKnownComponentAndIsLeastInTheOther)
{
  const Force n = direction(20.0), across = direction(110.0);
  for (const bool atFirst : {true, false}) {
    auto problem = randomFan(5, false, 8);
    (atFirst ? problem.atFirst : problem.atLast) = {{n, 0.7}};
    const auto flows = leastFlows(problem);
    expectStepsAreKept(problem, flows);
    EXPECT_NEAR(dot(n, atFirst ? flows.flow.front() : flows.flow.back()), 0.7, roundOff);
    EXPECT_NEAR(dot(across, slope(problem, flows)), 0.0, roundOff);
  }
}

TEST(Circulation, KeepsComponentsOfBothEnds)
{
  auto problem = randomFan(4, false, 2);
  problem.atFirst = {{direction(10.0), 0.3}};
  problem.atLast = {{direction(55.0), -0.4}};
  const auto flows = leastFlows(problem);
  expectStepsAreKept(problem, flows);
  EXPECT_NEAR(dot(direction(10.0), flows.flow.front()), 0.3, roundOff);
  EXPECT_NEAR(dot(direction(55.0), flows.flow.back()), -0.4, roundOff);
  EXPECT_LT(flows.defect, roundOff);
}

TEST(Circulation, ToleratesTheSameComponentAtBothEnds)
{
  const Force n = direction(33.0);
  auto problem = randomFan(4, false, 5);
  double through = 0.0;
  for (const Force step : problem.steps)
    through += dot(n, step);
  problem.atFirst = {{n, 0.2}};
  problem.atLast = {{-1.0 * n, -0.2 - through}};
  const auto flows = leastFlows(problem);
  EXPECT_NEAR(dot(n, flows.flow.front()), 0.2, roundOff);
  EXPECT_LT(flows.defect, roundOff);

  problem.atLast.front().value += 0.05;
  EXPECT_NEAR(leastFlows(problem).defect, 0.05, roundOff);
}

TEST(Circulation, DividesWhatAClosedFanLacksAmongItsCells)
{
  auto problem = randomFan(5, true, 4);
  problem.steps[2] = problem.steps[2] + Force{0.0, 0.1};
  const auto flows = leastFlows(problem);
  EXPECT_NEAR(flows.defect, 0.1, roundOff);
  EXPECT_LT(norm(flows.flow.back() - flows.flow.front()), roundOff);
  for (std::size_t k = 0; k < 5; ++k)
    EXPECT_NEAR(norm(flows.flow[k + 1] - flows.flow[k] - problem.steps[k]), 0.02, roundOff);
}

} // namespace ndframe

// What must not matter to a run with a target, and what it may cost.

#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "driver/scene.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

/// With what the program adds to a deck that names a target.
Scene toTarget(const std::string& deck, const std::string& target)
{
  return Scene(deck)
      .set("Accuracy/Target=" + target)
      .set("Error Estimation/Estimators={Global}")
      .set("Coupling/Initial Traction=Balanced");
}

std::vector<std::int64_t> dofsOfLevels(const Run& run)
{
  std::vector<std::int64_t> dofs;
  for (const auto& level : run.summary.accuracy->levels)
    dofs.push_back(level.dofs);
  return dofs;
}

std::vector<int> sweepsOfLevels(const Run& run)
{
  std::vector<int> sweeps;
  for (const auto& level : run.summary.accuracy->levels)
    sweeps.push_back(level.sweeps);
  return sweeps;
}

class RunToTarget : public testing::TestWithParam<const char*>
{};

} // namespace

TEST_P(RunToTarget, TakesTheSameWayInOtherUnits)
{
  const auto reference = toTarget(GetParam(), "0.02").run();
  const auto changed = toTarget(GetParam(), "0.02").changeUnits(1e-3, 2e11).run();
  EXPECT_GT(dofsOfLevels(reference.run).size(), 2u);
  EXPECT_EQ(dofsOfLevels(changed.run), dofsOfLevels(reference.run));
  EXPECT_EQ(sweepsOfLevels(changed.run), sweepsOfLevels(reference.run));
}

TEST_P(RunToTarget, TakesTheSameWayWithTheBodiesInAnotherOrder)
{
  const auto reference = toTarget(GetParam(), "0.02").run();
  const auto reversed = toTarget(GetParam(), "0.02").reverseBodies().run();
  EXPECT_EQ(dofsOfLevels(reversed.run), dofsOfLevels(reference.run));
  EXPECT_EQ(sweepsOfLevels(reversed.run), sweepsOfLevels(reference.run));
}

TEST_P(RunToTarget, FactorsEveryBodyOncePerMesh)
{
  const auto outcome = toTarget(GetParam(), "0.01").run();
  EXPECT_EQ(outcome.ledger->counted("factorisations"), 2 * std::int64_t(dofsOfLevels(outcome.run).size()));
}

INSTANTIATE_TEST_SUITE_P(Decks, RunToTarget, testing::Values("punch", "contact-loss"));

TEST(OneRunToTarget, TakesTheSameWayInTheMirror)
{
  const auto crossed = [] { // a pattern that is its own image
    return toTarget("punch", "0.02")
        .set("Accuracy/Start=Deck")
        .set("Bodies/punch/Mesh/Cells={2, 2}")
        .set("Bodies/foundation/Mesh/Cells={4, 2}")
        .set("Bodies/punch/Mesh/Pattern=Crossed")
        .set("Bodies/foundation/Mesh/Pattern=Crossed");
  };
  const auto image = crossed()
                         .set("Bodies/punch/Mesh/Lower={-1, 0}")
                         .set("Bodies/punch/Mesh/Upper={0, 1}")
                         .set("Bodies/punch/Supports/symmetry/Side=right")
                         .set("Bodies/foundation/Mesh/Lower={-2, -1}")
                         .set("Bodies/foundation/Mesh/Upper={0, 0}")
                         .set("Bodies/foundation/Mesh/Splits/under the punch/At={-1}")
                         .set("Bodies/foundation/Mesh/Splits/under the punch/Names={free, contact}")
                         .set("Bodies/foundation/Supports/symmetry/Side=right")
                         .run();
  EXPECT_EQ(dofsOfLevels(image.run), dofsOfLevels(crossed().run().run));
}

TEST(OneRunToTarget, NoMeshHasALargerBoundThanTheOneBefore)
{
  // Where contact opens, what is left of earlier tractions may cost more than the mesh: then sweeps must follow.
  const auto outcome = toTarget("hertz", "0.001").run();
  const auto& levels = outcome.run.summary.accuracy->levels;
  EXPECT_TRUE(outcome.run.summary.accuracy->reached);
  for (std::size_t l = 1; l < levels.size(); ++l)
    EXPECT_LT(levels[l].bound, levels[l - 1].bound) << "level " << levels[l].level;
}

TEST(OneRunToTarget, StopsAtTheLimitOfRoundOff)
{
  const auto outcome = toTarget("patch", "1e-15").run();
  const AccuracySummary& accuracy = *outcome.run.summary.accuracy;
  EXPECT_FALSE(accuracy.reached);
  EXPECT_NE(accuracy.limit.find("round-off"), std::string::npos) << accuracy.limit;
}

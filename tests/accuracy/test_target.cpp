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
      .set("Error Estimation/Recovery/Sweeps=1")
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

TEST(OneRunToTarget, HoldsMaximumDofsAndComesNearIt)
{
  for (const char* marking : {"Predicted", "Doerfler", "Uniform"})
    for (const int most : {500, 1000}) {
      const auto outcome = toTarget("punch", "0.005")
                               .set("Accuracy/Maximum Dofs=" + std::to_string(most))
                               .set(std::string("Accuracy/Marking/Type=") + marking)
                               .run();
      const AccuracySummary& accuracy = *outcome.run.summary.accuracy;
      EXPECT_FALSE(accuracy.reached);
      EXPECT_EQ(accuracy.limit, "Maximum Dofs = " + std::to_string(most));
      EXPECT_LE(accuracy.levels.back().dofs, most) << marking;
      EXPECT_GE(accuracy.levels.back().dofs, most / (marking == std::string("Predicted") ? 2 : 4)) << marking;
    }
}

TEST(OneRunToTarget, WritesTheBestAnswerWhereTheLastLevelIsWorse)
{
  const auto outcome = toTarget("punch", "0.01").set("Coupling/Relaxation/Theta=0.9").run();
  const AccuracySummary& accuracy = *outcome.run.summary.accuracy;
  ASSERT_FALSE(accuracy.reached);
  EXPECT_NE(accuracy.limit.find("the sweeps do not converge"), std::string::npos) << accuracy.limit;
  ASSERT_LT(accuracy.written, int(accuracy.levels.size()));
  for (const auto& level : accuracy.levels)
    EXPECT_GE(level.bound, accuracy.answer().bound);
  EXPECT_NEAR(outcome.run.summary.errors->global->absolute, accuracy.answer().bound, 1e-9 * accuracy.answer().bound);
  EXPECT_TRUE(outcome.run.summary.errors->guaranteed);
  EXPECT_EQ(outcome.run.model.totalDofs(), accuracy.answer().dofs);
}

TEST(OneRunToTarget, KeepsTheRolesThatTheFirstLevelChose)
{
  const auto outcome = toTarget("punch", "0.01")
                           .set("Coupling/Dirichlet Body=Automatic")
                           .set("Bodies/punch/Material/Young Modulus=100")
                           .run();
  EXPECT_TRUE(outcome.run.summary.accuracy->reached);
  ASSERT_EQ(outcome.run.summary.coupling->roles.size(), 1u);
  EXPECT_TRUE(outcome.run.summary.coupling->roles.front().exchanged);
  EXPECT_EQ(outcome.run.summary.interfaces.front().dirichletBody, "foundation");
  for (const int sweeps : sweepsOfLevels(outcome.run))
    EXPECT_LE(sweeps, 4);
}

TEST(OneRunToTarget, MoreSweepsComeBeforeAnotherMeshWhereTheyReachTheTarget)
{
  // With a large share for the sweeps the meshes alone would reach targets that the bounds miss.
  int levels = 0, reachedBySweeps = 0;
  for (const char* target : {"0.03", "0.02", "0.015", "0.01", "0.007"}) {
    const auto outcome = toTarget("punch", target).set("Accuracy/Iteration Share=0.9").run();
    const AccuracySummary& accuracy = *outcome.run.summary.accuracy;
    ASSERT_TRUE(accuracy.reached);
    for (const auto& level : accuracy.levels) {
      ++levels;
      const double norm = level.bound / level.relative;
      EXPECT_TRUE(level.level == int(accuracy.levels.size()) || level.mesh > accuracy.target * norm)
          << "level " << level.level << " to " << target << " needed sweeps only";
    }
    reachedBySweeps += accuracy.levels.back().iteration < 0.5 * accuracy.levels.back().mesh;
  }
  EXPECT_GT(levels, 10);
  EXPECT_GT(reachedBySweeps, 0);
}

TEST(OneRunToTarget, StopsAtTheLimitOfRoundOff)
{
  const auto outcome = toTarget("patch", "1e-15").run();
  const AccuracySummary& accuracy = *outcome.run.summary.accuracy;
  EXPECT_FALSE(accuracy.reached);
  EXPECT_NE(accuracy.limit.find("round-off"), std::string::npos) << accuracy.limit;
}

/// Within 3 Target of the interface's length, which is 1 here.
TEST(OneRunToTarget, BracketsTheEndOfContact)
{
  for (const double target : {0.03, 0.015, 0.006}) {
    for (const char* where : {"0.5", "0.3"}) {
      Scene scene = toTarget("contact-loss", std::to_string(target));
      const auto outcome = scene.set(std::string("Bodies/upper/Mesh/Splits/loaded part/At={") + where + "}").run();
      const auto& brackets = outcome.run.summary.interfaces.front().endBrackets;
      ASSERT_EQ(brackets.size(), 1u);
      EXPECT_LE(brackets[0].open[0] - brackets[0].closed[0], 3.0 * target) << where;
    }
  }
}

/// Facets of the first mesh are longer than the strips are wide: what polynomials do not carry of the load is most of
/// the bound, and marks have to see it.
TEST(OneRunToTarget, FollowsTheStripsOfALoad)
{
  for (const char* load : {"1+60*(x>0.37)*(x<0.41)", "1+30*(x>0.613)*(x<0.633)"}) {
    const auto outcome = toTarget("punch", "0.02").set(std::string("Bodies/punch/Loads/press/Value=") + load).run();
    const AccuracySummary& accuracy = *outcome.run.summary.accuracy;
    EXPECT_TRUE(accuracy.reached) << load << ": " << accuracy.limit;
    for (std::size_t i = 1; i < accuracy.levels.size(); ++i)
      EXPECT_LT(accuracy.levels[i].bound, accuracy.levels[i - 1].bound) << load << ", level " << i + 1;
  }
}

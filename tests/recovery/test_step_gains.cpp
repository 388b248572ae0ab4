// When a descent has gained what it can.

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "step_gains.hpp"

namespace ndframe
{

TEST(StepGains, AreTheShareOfTheBoundThatAStepTakesAway)
{
  StepGains gains(9.0);
  EXPECT_EQ(gains.mean(), 1.0);
  double bound = 3.0;
  for (int step = 0; step < 10; ++step) {
    gains.add(bound * bound * (1.0 - 0.9 * 0.9));
    bound *= 0.9;
    EXPECT_NEAR(gains.mean(), 0.1, 1e-13) << step;
    EXPECT_EQ(gains.areBelow(0.11), step >= 3) << step;
    EXPECT_FALSE(gains.areBelow(0.09)) << step;
  }
  EXPECT_NEAR(gains.lowered(), 9.0 - bound * bound, 1e-13);
}

TEST(StepGains, AreAMeanOfTheLastSteps)
{
  StepGains gains(1.0);
  for (const double lowered : {0.5, 0.0, 0.0, 0.19})
    gains.add(lowered);
  EXPECT_NEAR(gains.mean(), 1.0 - std::pow(0.31, 0.125), 1e-14);
  gains.add(0.0);
  EXPECT_NEAR(gains.mean(), 1.0 - std::pow(0.31 / 0.5, 0.125), 1e-14);
}

TEST(StepGains, AreNeverBelowWhereTheBoundIsNotKnown)
{
  for (const double square : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    StepGains gains(square);
    for (int step = 0; step < 10; ++step)
      gains.add(0.0);
    EXPECT_FALSE(gains.areBelow(1.0)) << square;
  }
}

/// A step that is stopped says nothing of the next ones, however short it was.
TEST(StepGains, AreNotBelowSoonAfterAStoppedStep)
{
  StepGains gains(1.0);
  for (int step = 0; step < 10; ++step) {
    gains.add(1e-6, step % 4 == 3);
    EXPECT_FALSE(step > 3 && gains.areBelow(0.1)) << step;
  }
  for (int step = 0; step < 4; ++step) {
    EXPECT_EQ(gains.areBelow(0.1), step >= 2) << step;
    gains.add(1e-6);
  }
  EXPECT_NEAR(gains.lowered(), 14e-6, 1e-15);
}

TEST(StepGains, WillReachWhatIsAFewStepsAway)
{
  StepGains gains(1.0);
  for (int step = 0; step < 4; ++step)
    gains.add(0.02 * std::pow(0.98, step)); // a hundredth of the bound a step, about
  const double square = std::pow(0.98, 4);
  EXPECT_TRUE(gains.willReach(0.999 * square));
  EXPECT_TRUE(gains.willReach(0.9 * square));
  EXPECT_FALSE(gains.willReach(0.8 * square));
  EXPECT_FALSE(gains.willReach(1.001 * square)) << "it is there";
  EXPECT_FALSE(gains.willReach(0.0));
}

/// A descent with a least gain of zero takes all its steps.
TEST(StepGains, OfNothingAreZero)
{
  StepGains gains(2.0);
  for (int step = 0; step < 4; ++step)
    gains.add(0.0);
  EXPECT_EQ(gains.mean(), 0.0);
  EXPECT_TRUE(gains.areBelow(1e-300));
  EXPECT_FALSE(gains.areBelow(0.0));
}

} // namespace ndframe

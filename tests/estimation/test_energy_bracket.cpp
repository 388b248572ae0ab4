// Brackets of the exact energy, and certificates that contradict each other.

#include <cmath>

#include <gtest/gtest.h>

#include "ndframe/estimation/energy_bracket.hpp"

using namespace ndframe;

namespace
{

EnergyBracket bracket(double lower, double upper, double roundOff = 0.0)
{
  EnergyBracket result;
  result.lower = lower;
  result.upper = upper;
  result.roundOff = roundOff;
  return result;
}

/// Of a stress at the distance D from an admissible displacement.
ErrorMeasure measureOf(double distance)
{
  ErrorMeasure measure;
  measure.elements = measure.widened = distance;
  return measure;
}

} // namespace

TEST(EnergyBracketOf, LinearScenesIsHalfTheSquareOfTheDistanceWide)
{
  const EnergyBracket found = bracketEnergy(measureOf(0.2), 3.0, 2.0);
  EXPECT_DOUBLE_EQ(found.upper, -0.5);
  EXPECT_DOUBLE_EQ(found.lower, -0.5 - 0.02);
}

TEST(EnergyBracketOf, ContactIsLowerByTheContactTerm)
{
  ErrorMeasure measure = measureOf(0.2);
  measure.contact = 0.06; // 2 int t^ (w^ - g)
  const EnergyBracket found = bracketEnergy(measure, 3.0, 2.0);
  EXPECT_NEAR(found.upper - found.lower, 0.5 * (0.04 + 0.06), 1e-15);
}

TEST(EnergyBracketOf, OscillationWidensItDownwardsOnly)
{
  ErrorMeasure measure = measureOf(0.2);
  measure.widened = 0.3;
  const EnergyBracket found = bracketEnergy(measure, 3.0, 2.0);
  EXPECT_DOUBLE_EQ(found.upper, -0.5);
  EXPECT_DOUBLE_EQ(found.lower, -0.5 - 0.045);
}

TEST(EnergyBracketOf, UnmetPrescribedDisplacementsWidenItBothWays)
{
  // One bar of stiffness 1, u(1) = 1 is prescribed and 1 - x is met: E = 1/2, E^ = (1 - x)^2 / 2, |l| = x, D = 0.
  for (const double x : {0.3, -0.3, 1e-3}) {
    ErrorMeasure measure = measureOf(0.0);
    measure.prescribed = std::abs(x);
    const EnergyBracket found = bracketEnergy(measure, (1.0 - x) * (1.0 - x), 0.0);
    EXPECT_LE(found.lower, 0.5 + 1e-15) << x;
    EXPECT_GE(found.upper, 0.5 - 1e-15) << x;
    EXPECT_LE(found.upper - found.lower, 3.0 * std::abs(x)) << x;
  }
}

TEST(EnergyRecord, KeepsTheBestOfAll)
{
  EnergyRecord record;
  EXPECT_FALSE(record.add(bracket(-3.0, -1.0), "level 1"));
  EXPECT_FALSE(record.add(bracket(-4.0, -1.5), "level 2"));
  EXPECT_FALSE(record.add(bracket(-2.0, -1.2), "level 3"));
  EXPECT_EQ(record.lower(), -2.0);
  EXPECT_EQ(record.upper(), -1.5);
  EXPECT_EQ(record.certificates(), 3);
  EXPECT_TRUE(record.holds());
}

TEST(EnergyRecord, SeesALowerEndAboveAnEarlierUpperOne)
{
  EnergyRecord record;
  record.add(bracket(-3.0, -1.0), "level 1");
  record.add(bracket(-3.5, -0.5), "level 2");
  const auto found = record.add(bracket(-0.9, -0.8), "level 3");
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->earlier, "level 1");
  EXPECT_EQ(found->later, "level 3");
  EXPECT_TRUE(found->newIsLower);
  EXPECT_EQ(found->lower, -0.9);
  EXPECT_EQ(found->upper, -1.0);
  EXPECT_FALSE(record.holds());
}

TEST(EnergyRecord, SeesAnUpperEndBelowAnEarlierLowerOne)
{
  EnergyRecord record;
  record.add(bracket(-5.0, 1.0), "level 1");
  record.add(bracket(-3.0, -1.0), "level 2");
  const auto found = record.add(bracket(-9.0, -7.0), "level 3");
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->earlier, "level 2");
  EXPECT_FALSE(found->newIsLower);
  EXPECT_EQ(found->lower, -3.0);
  EXPECT_EQ(found->upper, -7.0);
}

TEST(EnergyRecord, DoesNotMindRoundOff)
{
  EnergyRecord record;
  record.add(bracket(-1.0, -1.0, 1e-12), "level 1");
  EXPECT_FALSE(record.add(bracket(-1.0 + 1.9e-12, -1.0 + 2e-12, 1e-12), "level 2"));
  EXPECT_TRUE(record.add(bracket(-1.0 + 4.2e-12, -1.0 + 5e-12, 1e-12), "level 3"));
}

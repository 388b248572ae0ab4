#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stopping.hpp"

using namespace ndframe;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

namespace
{

constexpr ConvergenceAdvice fixedTheta{true, false, false};

/// The verdict after sweeps with a goal for the iteration's part of the error, which had these values; eps_tau never
/// falls.
CouplingResult verdictWithGoal(double goal, const Vector& iterationError, int maximumSweeps)
{
  CouplingResult result;
  for (const double value : iterationError) {
    result.history.emplace_back();
    result.history.back().sweep = int(result.history.size());
    result.history.back().epsTau = 2.0;
    result.history.back().iterationError = value;
  }
  Stopping(0.1, maximumSweeps, fixedTheta).withGoal(goal).ends(result, false);
  return result;
}

/// The verdict after sweeps with these values of eps_tau and these contact forces on the Dirichlet body.
CouplingResult verdict(const Stopping& stopping, const Vector& epsTau, const Vector& force, bool turned = false)
{
  CouplingResult result;
  for (std::size_t i = 0; i < epsTau.size(); ++i) {
    SweepRecord record;
    record.sweep = int(i) + 1;
    record.epsTau = epsTau[i];
    record.forceDirichlet = force[i];
    record.turned = turned && i > 0;
    result.history.push_back(record);
  }
  const bool ends = stopping.ends(result, false);
  EXPECT_EQ(ends, !result.reason.empty());
  return result;
}

} // namespace

TEST(StoppingMeasure, IsTheRelativeDifference)
{
  EXPECT_NEAR(Stopping::measure({3.0, 4.0}, {3.0, 2.0}), 2.0 * 2.0 / std::sqrt(72.0), 1e-15);
  EXPECT_EQ(Stopping::measure({-1.0, -2.0}, {-1.0, -2.0}), 0.0);
}

TEST(StoppingMeasure, IsTwoForAZeroStart)
{
  EXPECT_EQ(Stopping::measure({-3.0, -1.0}, {0.0, 0.0}), 2.0);
}

TEST(StoppingMeasure, IsZeroWhereThereIsNoTraction)
{
  EXPECT_EQ(Stopping::measure({0.0, 0.0}, {0.0, 0.0}), 0.0);
}

TEST(StoppingMeasure, DoesNotDependOnTheUnitOfStress)
{
  const Vector a{-1.0, -2.5, 0.25}, b{-1.5, -2.0, 0.5};
  const double plain = Stopping::measure(a, b);
  for (const double unit : {1e300, 1e9, 1e-9, 1e-300}) {
    Vector scaledA = a, scaledB = b;
    for (std::size_t i = 0; i < a.size(); ++i) {
      scaledA[i] *= unit;
      scaledB[i] *= unit;
    }
    EXPECT_NEAR(Stopping::measure(scaledA, scaledB), plain, 1e-14) << unit;
  }
}

TEST(Stopping, EndsBelowTheTolerance)
{
  const Stopping stopping(0.1, 10, fixedTheta);
  EXPECT_EQ(verdict(stopping, {2.0, 0.1}, {-1.0, -1.0}).reason, "");
  const auto result = verdict(stopping, {2.0, 0.0912}, {-1.0, -1.0});
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.reason, "eps_tau 0.0912 < 0.1");
}

TEST(Stopping, MaximumSweepsIsNotConverged)
{
  const auto result = verdict(Stopping(0.1, 3, fixedTheta), {2.0, 0.5, 0.25}, {-1.0, -1.0, -1.0});
  EXPECT_FALSE(result.converged);
  EXPECT_THAT(result.reason, AllOf(HasSubstr("eps_tau 0.25 has not fallen below 0.1 in 3 sweeps (Maximum Sweeps)"),
                                   Not(HasSubstr("Theta"))));
}

TEST(Stopping, OneSweepCannotTellWhetherItHelps)
{
  EXPECT_THAT(verdict(Stopping(0.1, 1, fixedTheta), {2.0}, {-1.0}).reason, Not(HasSubstr("Theta")));
}

TEST(Stopping, SweepsThatDoNotHelpAdviseAboutTheta)
{
  for (const Vector& jumping : {Vector{2.0, 1.5, 1.4, 1.5}, Vector{2.0, 1.4, 1.9, 1.4}, Vector{1.4, 2.0, 1.4, 1.9}})
    EXPECT_THAT(verdict(Stopping(0.1, 4, fixedTheta), jumping, Vector(4, -1.0), true).reason,
                HasSubstr("and hardly falls; a smaller Theta, Coupling/Relaxation/Type = Automatic"));
}

TEST(Stopping, SweepsThatCreepAdviseALargerTheta)
{
  EXPECT_THAT(verdict(Stopping(0.1, 4, fixedTheta), {2.0, 1.99, 1.98, 1.97}, Vector(4, -1.0)).reason,
              HasSubstr("and hardly falls; a larger Theta, Coupling/Relaxation/Type = Automatic"));
}

TEST(Stopping, AdvisesNothingThatIsSetAlready)
{
  const auto advice = [](ConvergenceAdvice set) {
    return verdict(Stopping(0.1, 4, set), {2.0, 1.99, 1.98, 1.97}, Vector(4, -1.0)).reason;
  };
  const char *theta = "Theta", *relaxation = "Relaxation/Type = Automatic", *roles = "Dirichlet Body = Automatic";
  EXPECT_THAT(advice({true, false, false}), AllOf(HasSubstr(theta), HasSubstr(relaxation), HasSubstr(roles)));
  EXPECT_THAT(advice({false, false, true}), AllOf(Not(HasSubstr(theta)), HasSubstr(relaxation), Not(HasSubstr(roles))));
  EXPECT_THAT(advice({false, true, false}), AllOf(Not(HasSubstr(theta)), Not(HasSubstr(relaxation)), HasSubstr(roles)));
  EXPECT_THAT(advice({false, true, true}), HasSubstr("hardly falls; Coupling/Type = Monolithic may help"));
}

TEST(Stopping, ForcesThatGrowWithoutBoundDiverge)
{
  const auto result = verdict(Stopping(0.1, 100, fixedTheta), {2.0, 2.0, 1.9}, {0.0, -1e-3, -1e28});
  EXPECT_FALSE(result.converged);
  EXPECT_THAT(result.reason, HasSubstr("diverges (sweep 3); a smaller Theta, Coupling/Relaxation/Type = Automatic"));
  EXPECT_THAT(verdict(Stopping(0.1, 100, fixedTheta), {2.0, std::nan("")}, {-1.0, std::nan("")}).reason,
              HasSubstr("diverges"));
}

TEST(Stopping, EndsWhereTheForcesAgreeToRoundOff)
{
  CouplingResult result;
  result.history.emplace_back();
  result.history.back().epsTau = 0.3;
  EXPECT_TRUE(Stopping(0.1, 10, fixedTheta).ends(result, true));
  EXPECT_TRUE(result.converged);
  EXPECT_THAT(result.reason, HasSubstr("agree to round-off of the loads (eps_tau 0.3)"));
}

TEST(Stopping, AGoalForTheIterationTakesThePlaceOfEpsTau)
{
  EXPECT_EQ(verdictWithGoal(1e-3, {0.1, 1e-3}, 10).reason, "");
  const auto result = verdictWithGoal(1e-3, {0.1, 3.14159e-4}, 10);
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.reason, "iteration 0.000314 < 0.001 (energy norm)");
}

TEST(Stopping, AGoalThatIsNotMetIsNotConverged)
{
  const auto falling = verdictWithGoal(1e-3, {0.1, 0.05, 0.02}, 3), stuck = verdictWithGoal(1e-3, {0.1, 0.1, 0.1}, 3);
  EXPECT_FALSE(falling.converged);
  EXPECT_EQ(falling.reason, "iteration 0.02 has not fallen below 0.001 (energy norm) in 3 sweeps (Maximum Sweeps)");
  EXPECT_FALSE(stuck.converged);
  EXPECT_THAT(stuck.reason,
              HasSubstr("(Maximum Sweeps) and hardly falls; a larger Theta, Coupling/Relaxation/Type = Automatic"));
}

#include <gtest/gtest.h>

#include <random>

#include "admissibility/sample_problems.hpp"
#include "body_stars.hpp"
#include "common/test_main.hpp"
#include "equilibrium/sample_stress.hpp"
#include "ndframe/admissibility/make_static_data.hpp"
#include "ndframe/equilibrium/settle_balance.hpp"

namespace ndframe
{
namespace
{

StressCorrection recovered(const test::Problem& problem)
{
  Ledger ledger;
  return BodyStars(problem.body, problem.data).solve({problem.field()}, test::comm(), ledger)[0];
}

double largestDefect(const test::Problem& problem, const StressCorrection& correction)
{
  return checkEquilibrium(problem.body, problem.data, problem.field(), correction).largest();
}

/// Every number is off by up to `size` of the largest.
void disturb(Vector& values, double size)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> noise(-size, size);
  const double scale = test::largest(values);
  for (double& value : values)
    value += scale * noise(random);
}

} // namespace

struct Settling : testing::TestWithParam<test::Space>
{};

TEST_P(Settling, TakesDisturbancesOutOfTheBalance)
{
  const auto [dim, order, degree] = GetParam();
  for (const std::string& kind : test::conditionKinds()) {
    const auto problem =
        test::solved(test::makeBody(test::sampleMesh(dim, 35.0), order, test::conditions(dim, kind)), degree);
    StressCorrection correction = recovered(problem);
    const double before = test::energyOf(problem.body, correction);
    disturb(correction.tractions, 1e-6);
    disturb(correction.loads, 1e-6);
    ASSERT_GT(largestDefect(problem, correction), 1e-8) << kind;
    settleBalance(problem.body, problem.data, problem.field(), correction);
    EXPECT_LT(largestDefect(problem, correction), 1e-12) << kind;
    EXPECT_LT(correction.defect(), 1e-12) << kind;
    EXPECT_NEAR(test::energyOf(problem.body, correction), before, 1e-3 * before) << kind;
  }
}

TEST_P(Settling, LeavesABalancedStressAlone)
{
  const auto [dim, order, degree] = GetParam();
  const auto problem =
      test::solved(test::makeBody(test::sampleMesh(dim, 35.0), order, test::conditions(dim, "rollers")), degree);
  const StressCorrection correction = recovered(problem);
  StressCorrection settled = correction;
  settleBalance(problem.body, problem.data, problem.field(), settled);
  const double size = test::largest(correction.tractions);
  EXPECT_LT(test::largest(test::difference(settled.tractions, correction.tractions)), 1e-12 * size);
  EXPECT_LT(test::largest(test::difference(settled.loads, correction.loads)), 1e-12 * size);
}

/// Rollers on one side do not take what pushes along it.
TEST_P(Settling, SaysWhatNoSupportTakes)
{
  const auto [dim, order, degree] = GetParam();
  test::Conditions conditions = test::conditions(dim, "rollers");
  const auto held = test::solved(test::makeBody(test::sampleMesh(dim, 35.0), order, conditions), degree);
  conditions.supports.resize(1);
  test::Problem loose{test::makeBody(test::sampleMesh(dim, 35.0), order, conditions), {}, held.displacement};
  loose.data = makeStaticData(loose.body, degree, {});
  StressCorrection correction = recovered(held);
  settleBalance(loose.body, loose.data, loose.field(), correction);
  EXPECT_GT(correction.defect(), 1e-2);
  EXPECT_GT(largestDefect(loose, correction), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(AllSpaces, Settling, testing::ValuesIn(test::allSpaces()), test::spaceName);

TEST(Settling, IsForFinelyGradedMeshes)
{
  StressCorrection correction;
  correction.force = 1.0;
  correction.imbalance = 2e-14;
  const Mesh even = test::sampleMesh(2, 0.0);
  EXPECT_FALSE(needsSettling(even, correction, Comm::single()));
  EXPECT_TRUE(
      needsSettling(test::moved(even, [](double* x) { x[0] = std::pow(x[0], 8); }), correction, Comm::single()));
}

} // namespace ndframe

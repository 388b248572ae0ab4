// The recovery of solids: balance whatever the conditions, the energy falls with every step, towards the least one.

#include <gmock/gmock.h>

#include "admissibility/sample_problems.hpp"
#include "common/test_main.hpp"
#include "equilibrium/sample_stress.hpp"
#include "mechanics/sample_laws.hpp"
#include "recovery/sample_recovery.hpp"

namespace ndframe
{

namespace
{

constexpr double roundOff = 1e-12;

StressCorrection recovered(const test::Problem& problem, const std::string& type, const std::string& effort, int amount,
                           Ledger& ledger)
{
  const RecoveryScene scene{{&problem.body}, {problem.data}, {}};
  SceneField field;
  field.displacement = {&problem.displacement};
  const auto recovery = test::makeRecovery(type, {{"Degree", problem.data.degree}, {effort, amount}});
  return test::recoverWhole(*recovery, scene, {field}, ledger)[0].corrections[0];
}

StressCorrection recovered(const test::Problem& problem, const std::string& type, const std::string& effort, int amount)
{
  Ledger ledger;
  return recovered(problem, type, effort, amount, ledger);
}

StressCorrection recovered(const test::Problem& problem, int steps = 10)
{
  return recovered(problem, "Global", "Steps", steps);
}

double largestDefect(const test::Problem& problem, const StressCorrection& correction)
{
  return checkEquilibrium(problem.body, problem.data, problem.field(), correction).largest();
}

double energyOf(const test::Problem& problem, const StressCorrection& correction)
{
  return test::energyOf(problem.body, correction);
}

test::Problem sampleProblem(const test::Space& space, const std::string& kind, unsigned numbering = 0)
{
  Mesh mesh = test::sampleMesh(3, 35.0);
  if (numbering > 0)
    mesh = test::renumbered(mesh, numbering);
  return test::solved(test::makeBody(std::move(mesh), space.order, test::conditions(3, kind)), space.degree);
}

} // namespace

struct GlobalRecovery : testing::TestWithParam<test::Space>
{};
INSTANTIATE_TEST_SUITE_P(Degrees, GlobalRecovery,
                         testing::Values(test::Space{3, 1, 1}, test::Space{3, 1, 2}, test::Space{3, 2, 2}),
                         test::spaceName);

TEST_P(GlobalRecovery, GivesEquilibriumWhateverTheConditions)
{
  for (const std::string& kind : test::conditionKinds()) {
    const auto problem = sampleProblem(GetParam(), kind);
    for (const int steps : {0, 10}) {
      const StressCorrection correction = recovered(problem, steps);
      EXPECT_LT(largestDefect(problem, correction), roundOff) << kind << ", steps " << steps;
      EXPECT_LT(correction.imbalance, roundOff * correction.force) << kind;
    }
  }
}

TEST_P(GlobalRecovery, FindsOneMatrixForCellsThatDifferByPlaceAndSizeAlone)
{
  const auto problemOn = [](const Mesh& mesh, const std::string& kind) {
    return test::solved(test::makeBody(mesh, GetParam().order, test::conditions(3, kind)), GetParam().degree);
  };
  const Mesh equal = test::box({4, 4, 4}, "Right", 35.0);
  test::Random random(5);
  const Mesh nearlyEqual =
      test::moved(equal, [&](double* x) { x[0] += 1e-14 * random(); }); // rounds to several classes
  for (const std::string& kind : test::conditionKinds())
    for (const Mesh& mesh : {equal, nearlyEqual}) {
      const auto problem = problemOn(mesh, kind);
      Ledger ledger;
      const StressCorrection correction = recovered(problem, "Global", "Steps", 10, ledger);
      EXPECT_LT(largestDefect(problem, correction), roundOff) << kind;
      EXPECT_LT(energyOf(problem, correction), energyOf(problem, recovered(problem, 0))) << kind;
      if (mesh.points == equal.points)
        EXPECT_EQ(ledger.counted("cell matrices"), 6) << kind;
    }
  Ledger ledger;
  const auto apart = problemOn(test::sampleMesh(3, 35.0), "clamped");
  recovered(apart, "Global", "Steps", 1, ledger);
  EXPECT_EQ(ledger.counted("cell matrices"), apart.body.mesh.numCells());
}

TEST_P(GlobalRecovery, GivesEquilibriumWhateverTheMaterialAlsoOnSlivers)
{
  const Mesh thin = test::moved(test::sampleMesh(3, 0.0), [](double* x) { x[1] *= 0.1; });
  for (const Elasticity& law : test::sampleLaws(3)) {
    BodyModel body = test::makeBody(thin, GetParam().order, test::conditions(3, "corner"));
    body.laws = law;
    const auto problem = test::solved(std::move(body), GetParam().degree);
    const StressCorrection correction = recovered(problem);
    // Slivers begin with tractions far above those at the end, and with their round-off.
    EXPECT_LT(largestDefect(problem, correction), 50.0 * roundOff + 1000.0 * correction.imbalance / correction.force);
    EXPECT_LT(correction.imbalance, 1e-11 * correction.force);
  }
}

TEST_P(GlobalRecovery, LowersTheEnergyWithEveryStepToThatOfManySweeps)
{
  for (const std::string& kind : test::conditionKinds()) {
    const auto problem = sampleProblem(GetParam(), kind);
    double energy = energyOf(problem, recovered(problem, 0));
    for (const int steps : {1, 2, 5, 10, 20, 40}) {
      const double lower = energyOf(problem, recovered(problem, steps));
      EXPECT_LT(lower, energy * (1.0 + 1e-6)) << kind << ", steps " << steps;
      energy = lower;
    }
    const double least = energyOf(problem, recovered(problem, 100)),
                 bySweeps = energyOf(problem, recovered(problem, "Star", "Sweeps", 10));
    EXPECT_LT(least, 1.01 * bySweeps) << kind;
    EXPECT_GT(least, 0.9 * bySweeps) << kind;
    EXPECT_LT(energyOf(problem, recovered(problem, 20)), 1.25 * least) << kind;
  }
}

TEST_P(GlobalRecovery, DoesNotDependOnTheNumbering)
{
  const auto problem = sampleProblem(GetParam(), "corner"), other = sampleProblem(GetParam(), "corner", 5);
  const double energy = energyOf(problem, recovered(problem)), again = energyOf(other, recovered(other));
  EXPECT_NEAR(again, energy, 1e-5 * energy); // steps have single precision
}

} // namespace ndframe

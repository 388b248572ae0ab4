// The recovery of solids: balance whatever the conditions, the energy falls with every step, towards the least one.

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include "admissibility/sample_problems.hpp"
#include "common/test_main.hpp"
#include "equilibrium/sample_stress.hpp"
#include "mechanics/sample_laws.hpp"
#include "recovery/sample_recovery.hpp"
#include "stress_descent.hpp"

namespace ndframe
{

namespace
{

constexpr double roundOff = 1e-12;

StressCorrection recovered(const test::Problem& problem, const StressRecovery& recovery, Ledger& ledger,
                           double enough = 0.0)
{
  const RecoveryScene scene{{&problem.body}, {problem.data}, {}};
  SceneField field;
  field.displacement = {&problem.displacement};
  field.enough = enough;
  return test::recoverWhole(recovery, scene, {field}, ledger)[0].corrections[0];
}

StressCorrection recovered(const test::Problem& problem, int steps = 10)
{
  Ledger ledger;
  return recovered(problem, *test::withSteps(problem.data.degree, steps), ledger);
}

/// As many as lower the bound by a share of it.
std::int64_t stepsTaken(const test::Problem& problem, std::vector<std::pair<std::string, double>> entries = {},
                        const std::string& type = "Global")
{
  Ledger ledger;
  entries.emplace_back("Degree", problem.data.degree);
  recovered(problem, *test::makeRecovery(type, entries), ledger);
  return ledger.counted("recovery steps");
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
  const Mesh equal = test::box({3, 3, 3}, "Right", 35.0);
  test::Random random(5);
  const Mesh nearlyEqual =
      test::moved(equal, [&](double* x) { x[0] += 1e-14 * random(); }); // rounds to several classes
  for (const std::string& kind : test::conditionKinds())
    for (const Mesh& mesh : {equal, nearlyEqual}) {
      const auto problem = problemOn(mesh, kind);
      Ledger ledger;
      const StressCorrection correction = recovered(problem, *test::withSteps(GetParam().degree, 10), ledger);
      EXPECT_LT(largestDefect(problem, correction), roundOff) << kind;
      EXPECT_LT(energyOf(problem, correction), energyOf(problem, recovered(problem, 0))) << kind;
      if (mesh.points == equal.points) {
        EXPECT_EQ(ledger.counted("cell matrices"), 6) << kind;
      }
    }
  Ledger ledger;
  const auto apart = problemOn(test::sampleMesh(3, 35.0), "clamped");
  recovered(apart, *test::withSteps(GetParam().degree, 1), ledger);
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
    Ledger ledger;
    const auto stars = test::makeRecovery("Star", {{"Degree", GetParam().degree}, {"Sweeps", 10}});
    const double least = energyOf(problem, recovered(problem, 100)),
                 bySweeps = energyOf(problem, recovered(problem, *stars, ledger));
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

TEST_P(GlobalRecovery, TellsTheEnergyThatItLeaves)
{
  for (const std::string& kind : test::conditionKinds())
    for (const Mesh& mesh : {test::sampleMesh(3, 35.0), test::box({3, 3, 3}, "Right", 35.0)}) { // alone, in classes
      const auto problem =
          test::solved(test::makeBody(mesh, GetParam().order, test::conditions(3, kind)), GetParam().degree);
      const StarBody body(problem.body, problem.data);
      const StressCells cells({&body});
      const StressFaces faces(cells);
      StressCorrection correction = recovered(problem, 0);
      const DescentWatch watch{[] {}, [](double) {}};
      const std::vector<ContactPatch> none;
      StressDescent descent(faces, none, {{{&correction}}}, watch, Comm::single(), 1);
      EXPECT_NEAR(descent.energy(0), energyOf(problem, correction), 1e-10 * energyOf(problem, correction)) << kind;
      EXPECT_EQ(descent.lower({30, 0.0}), 30);
      EXPECT_NEAR(descent.energy(0), energyOf(problem, correction), 1e-5 * energyOf(problem, correction)) << kind;
    }
}

/// Starts are kept in single precision, in units that the first cells with anything decide on.
TEST_P(GlobalRecovery, DoesNotDependOnHowLittleTheFirstCellsHave)
{
  const auto energyWith = [](const Mesh& mesh, double little) {
    const auto problem =
        test::solved(test::makeBody(mesh, GetParam().order, test::conditions(3, "clamped")), GetParam().degree);
    const StarBody body(problem.body, problem.data);
    const StressCells cells({&body});
    const StressFaces faces(cells);
    StressCorrection correction = recovered(problem, 0);
    for (Vector* data : {&correction.tractions, &correction.loads})
      std::for_each(data->begin(), data->begin() + std::ptrdiff_t(data->size() / 2),
                    [little](double& value) { value *= little; });
    const DescentWatch watch{[] {}, [](double) {}};
    const std::vector<ContactPatch> none;
    StressDescent descent(faces, none, {{{&correction}}}, watch, Comm::single(), 1);
    const double before = descent.energy(0);
    descent.lower({20, 0.0});
    return std::array{before, descent.energy(0)};
  };
  for (const Mesh& mesh : {test::sampleMesh(3, 35.0), test::box({3, 3, 3}, "Right", 35.0)}) { // alone, in classes
    const auto [start, end] = energyWith(mesh, 0.0);
    EXPECT_LT(end, 0.99 * start);
    for (const double little : {1e-10, 1e-60}) {
      const auto [before, after] = energyWith(mesh, little);
      EXPECT_NEAR(before, start, 1e-6 * start) << little;
      EXPECT_NEAR(after, end, 1e-5 * start) << little;
    }
  }
}

TEST_P(GlobalRecovery, TakesMoreStepsWhereCellsAreStretched)
{
  const auto stepsOn = [](double height) {
    const Mesh mesh = test::moved(test::box({4, 4, 4}, "Right", 0.0), [=](double* x) { x[2] *= height; });
    return stepsTaken(
        test::solved(test::makeBody(mesh, GetParam().order, test::conditions(3, "clamped")), GetParam().degree));
  };
  const std::int64_t cubes = stepsOn(1.0), plates = stepsOn(0.2);
  EXPECT_LT(cubes, 30);
  EXPECT_GT(plates, 5 * cubes / 4);
  EXPECT_GT(stepsOn(0.05), plates);
}

TEST_P(GlobalRecovery, TakesStepsAsLongAsTheyGainEnough)
{
  const auto problem = sampleProblem(GetParam(), "clamped");
  const double start = energyOf(problem, recovered(problem, 0));
  const auto boundAfter = [&](std::int64_t steps) {
    return std::sqrt(energyOf(problem, recovered(problem, int(steps))) / start);
  };
  const std::int64_t steps = stepsTaken(problem, {{"Least Gain", 0.01}});
  const auto gainUntil = [&](std::int64_t last) {
    return 1.0 - std::pow(boundAfter(last) / boundAfter(last - 4), 1.0 / 4.0);
  };
  EXPECT_LT(gainUntil(steps), 0.01);
  EXPECT_GT(gainUntil(steps - 1), 0.01);
  EXPECT_EQ(stepsTaken(problem, {{"Least Gain", 0.01}, {"Steps", 5}}), 5);
  EXPECT_EQ(stepsTaken(problem, {{"Least Gain", 0.0}, {"Steps", 50}}), 50);
  EXPECT_EQ(stepsTaken(problem, {{"Steps", 0}}), 0);
}

/// Where what is enough is near, and only there.
TEST_P(GlobalRecovery, TakesMoreStepsToABoundThatIsEnough)
{
  const auto problem = sampleProblem(GetParam(), "clamped");
  const auto recovery =
      test::makeRecovery("Global", {{"Degree", double(problem.data.degree)}, {"Least Gain", 0.03}, {"Steps", 60}});
  const auto stepsTo = [&](double enough) {
    Ledger ledger;
    recovered(problem, *recovery, ledger, enough);
    return ledger.counted("recovery steps");
  };
  const std::int64_t usual = stepsTo(0.0);
  const auto energyAfter = [&](std::int64_t steps) { return energyOf(problem, recovered(problem, int(steps))); };
  for (const std::int64_t more : {1, 2, 3})
    EXPECT_EQ(stepsTo(0.5 * (energyAfter(usual + more - 1) + energyAfter(usual + more))), usual + more);
  for (const std::int64_t before : {0, 1, 3})
    EXPECT_EQ(stepsTo(1.001 * energyAfter(usual - before)), usual);
  EXPECT_EQ(stepsTo(0.3 * energyAfter(usual)), usual) << "out of reach";
  EXPECT_LT(stepsTo(0.999 * energyAfter(60)), 60) << "given up where it turns out to be out of reach";
}

TEST_P(GlobalRecovery, SweepsOfAutomaticHalveTheGain)
{
  const auto problem = sampleProblem(GetParam(), "rollers");
  std::int64_t last = 0;
  for (const int sweeps : {0, 1, 2, 4}) {
    const std::int64_t steps = stepsTaken(problem, {{"Sweeps", sweeps}}, "Automatic");
    EXPECT_EQ(steps, stepsTaken(problem, {{"Least Gain", std::ldexp(0.01, -sweeps)}})) << sweeps;
    EXPECT_GT(steps, last);
    last = steps;
  }
}

TEST_P(GlobalRecovery, TakesNoStepsWhereNothingActs)
{
  test::Conditions conditions;
  conditions.supports = {test::onSide("Clamp", "left")};
  const auto problem =
      test::solved(test::makeBody(test::sampleMesh(3, 35.0), GetParam().order, conditions), GetParam().degree);
  EXPECT_EQ(stepsTaken(problem), 0);
  EXPECT_EQ(energyOf(problem, recovered(problem)), 0.0);
}

} // namespace ndframe

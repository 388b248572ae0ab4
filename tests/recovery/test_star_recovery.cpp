#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "admissibility/sample_problems.hpp"
#include "body_stars.hpp"
#include "common/test_main.hpp"
#include "equilibrium/sample_stress.hpp"
#include "ndframe/admissibility/make_static_data.hpp"
#include "recovery/sample_recovery.hpp"

namespace ndframe
{

namespace
{

constexpr double roundOff = 1e-12;

StressCorrection recovered(const test::Problem& problem, int sweeps = 0, StarKernels kernels = StarKernels::Batched)
{
  Ledger ledger;
  BodyStars stars(problem.body, problem.data, kernels);
  auto corrections = stars.solve({problem.field()}, test::comm(), ledger);
  for (int sweep = 0; sweep < sweeps; ++sweep)
    stars.sweep(corrections, test::comm(), ledger);
  return corrections[0];
}

test::Problem sampleProblem(const test::Space& space, const std::string& kind, double rotation = 0.0)
{
  return test::solved(
      test::makeBody(test::sampleMesh(space.dim, rotation), space.order, test::conditions(space.dim, kind)),
      space.degree);
}

double largestDefect(const test::Problem& problem, const StressCorrection& correction)
{
  return checkEquilibrium(problem.body, problem.data, problem.field(), correction).largest();
}

/// Displacements of all sides prescribed to an affine field.
test::Conditions affine(const Mesh& mesh)
{
  test::Conditions conditions;
  for (const Side& side : mesh.sides) {
    auto support = test::onSide("Displacement", side.name);
    support.entries.insert(support.entries.end(), {{"X", "0.1 + 0.2*x - 0.3*y"}, {"Y", "0.4*x + 0.1*y"}});
    if (mesh.dim == 3)
      support.entries.emplace_back("Z", "0.2*y - 0.1*z");
    conditions.supports.push_back(support);
  }
  return conditions;
}

} // namespace

struct Stars : testing::TestWithParam<test::Space>
{};

TEST_P(Stars, GiveEquilibriumWhateverTheConditions)
{
  for (const std::string& kind : test::conditionKinds()) {
    const auto problem = sampleProblem(GetParam(), kind, 35.0);
    const StressCorrection correction = recovered(problem, 0, StarKernels::General);
    EXPECT_LT(largestDefect(problem, correction), roundOff) << kind;
    EXPECT_LT(correction.imbalance, roundOff * correction.force) << kind;
    EXPECT_GT(test::energyOf(problem.body, correction), 0.0);
  }
}

TEST_P(Stars, DoNotDependOnTheKernels)
{
  if (GetParam().dim == 3)
    GTEST_SKIP() << "no batches in three dimensions";
  for (const std::string& kind : test::conditionKinds())
    for (const int sweeps : {0, 2}) {
      const auto problem = sampleProblem(GetParam(), kind, 35.0);
      const StressCorrection general = recovered(problem, sweeps, StarKernels::General);
      const StressCorrection batched = recovered(problem, sweeps, StarKernels::Batched);
      const double size = test::largest(general.tractions);
      EXPECT_LT(test::largest(test::difference(batched.tractions, general.tractions)), 1e-11 * size) << kind << sweeps;
      EXPECT_LT(test::largest(test::difference(batched.loads, general.loads)), 1e-11 * size) << kind << sweeps;
      EXPECT_GT(batched.force, 0.1 * general.force);
      EXPECT_LT(batched.force, 10.0 * general.force);
    }
}

TEST_P(Stars, GiveEquilibriumWhateverTheMaterialAlsoOnSlivers)
{
  const auto [dim, order, degree] = GetParam();
  const Mesh thin = test::moved(test::sampleMesh(dim, 0.0), [](double* x) { x[1] *= 0.1; });
  for (const Elasticity& law : test::sampleLaws(dim)) {
    BodyModel body = test::makeBody(thin, order, test::conditions(dim, "corner"));
    body.laws = law;
    const auto problem = test::solved(std::move(body), degree);
    const StressCorrection correction = recovered(problem);
    // Nearly incompressible or bent slivers: the round-off of sigma~ itself, seen as the stars' imbalance.
    EXPECT_LT(largestDefect(problem, correction), roundOff + 1000.0 * correction.imbalance / correction.force);
    EXPECT_LT(correction.imbalance, 1e-11 * correction.force);
  }
}

TEST_P(Stars, AddNothingToAnAffineDisplacement)
{
  const Mesh mesh = test::sampleMesh(GetParam().dim, 0.0);
  const auto problem = test::solved(test::makeBody(mesh, GetParam().order, affine(mesh)), GetParam().degree);
  const StressCorrection correction = recovered(problem);
  EXPECT_LT(test::largest(correction.tractions), roundOff * correction.force);
  EXPECT_LT(test::largest(correction.loads), roundOff * correction.force);
}

TEST_P(Stars, SweepsLowerTheEnergyAndKeepTheEquilibrium)
{
  const auto problem = sampleProblem(GetParam(), "corner");
  Ledger ledger;
  BodyStars stars(problem.body, problem.data);
  auto corrections = stars.solve({problem.field()}, test::comm(), ledger);
  double energy = test::energyOf(problem.body, corrections[0]);
  for (int sweep = 0; sweep < 3; ++sweep) {
    stars.sweep(corrections, test::comm(), ledger);
    const double next = test::energyOf(problem.body, corrections[0]);
    EXPECT_LT(next, energy * (1.0 - 1e-4)) << sweep;
    energy = next;
  }
  EXPECT_LT(largestDefect(problem, corrections[0]), roundOff);
}

TEST_P(Stars, BalanceContactTractionsLikeLoads)
{
  const auto loaded = sampleProblem(GetParam(), "corner"); // loads on the right
  const Facet corner = loaded.body.mesh.findSide("right")->facets[0];
  test::Problem pressed = sampleProblem(GetParam(), "corner");
  Vector shares;
  std::vector<BoundaryFacet> others;
  std::vector<double> othersShares;
  const std::size_t perFacet = loaded.data.facetShares.size() / loaded.data.boundary.size();
  for (std::size_t i = 0; i < loaded.data.boundary.size(); ++i) {
    const BoundaryFacet& facet = loaded.data.boundary[i];
    const auto* first = loaded.data.facetShares.data() + i * perFacet;
    const bool isContact = facet.facet.cell == corner.cell && facet.facet.local == corner.local;
    (isContact ? shares : othersShares).insert((isContact ? shares : othersShares).end(), first, first + perFacet);
    if (isContact)
      pressed.data.contact.push_back(facet.facet);
    else
      others.push_back(facet);
  }
  ASSERT_EQ(pressed.data.contact.size(), 1U);
  pressed.data.boundary = others;
  pressed.data.facetShares = othersShares;
  Ledger ledger;
  const auto correction =
      BodyStars(pressed.body, pressed.data).solve({{&pressed.displacement, &shares}}, test::comm(), ledger)[0];
  const StressCorrection expected = recovered(loaded);
  EXPECT_LT(test::largest(test::difference(correction.tractions, expected.tractions)), roundOff * expected.force);
}

INSTANTIATE_TEST_SUITE_P(AllSpaces, Stars, testing::ValuesIn(test::allSpaces()), test::spaceName);

TEST(StarSweeps, AHigherDegreeIsNoWorse)
{
  for (const int order : {1, 2}) {
    const auto low = sampleProblem({2, order, order}, "clamped"),
               high = sampleProblem({2, order, order + 1}, "clamped");
    const double bound = test::energyOf(low.body, recovered(low, 5));
    EXPECT_LT(test::energyOf(high.body, recovered(high, 5)), bound);
  }
}

TEST(StarSweeps, ApproachTheLeastEnergy)
{
  const auto problem = sampleProblem({2, 2, 2}, "clamped");
  const double ten = test::energyOf(problem.body, recovered(problem, 10));
  EXPECT_NEAR(test::energyOf(problem.body, recovered(problem, 20)), ten, 1e-3 * ten);
}

TEST(StarDefect, TellsThatTheInputIsNotInEquilibrium)
{
  auto problem = sampleProblem({2, 2, 2}, "clamped");
  EXPECT_LT(recovered(problem).imbalance, 1e-13 * recovered(problem).force);
  const int node = problem.body.mesh.cell(5)[1];
  const double size = test::largest(problem.displacement);
  problem.displacement[std::size_t(2 * node)] += 1e-6 * size;
  const StressCorrection wrong = recovered(problem);
  EXPECT_GT(wrong.imbalance, 1e-8 * wrong.force);
}

TEST(StarRefusal, MeshThatTouchesItselfInAPoint)
{
  // Two triangles with the point (1, 1) in common.
  Mesh mesh{2, {0, 0, 1, 0, 1, 1, 2, 1, 2, 2}, {0, 1, 2, 2, 3, 4}, {{"left", {{0, 0}}}, {"right", {{1, 0}}}}, {}};
  test::Problem problem{
      test::makeBody(mesh, 1, {{test::onSide("Clamp", "left"), test::onSide("Clamp", "right")}, {}}), {}, {}};
  problem.displacement.assign(std::size_t(problem.body.numDofs()), 0.0);
  problem.data = makeStaticData(problem.body, 1, {});
  const std::string message = test::complaint([&] { recovered(problem); });
  EXPECT_THAT(message, testing::HasSubstr("Bodies/body"));
  EXPECT_THAT(message, testing::HasSubstr("touches itself at the point (1, 1)"));
}

TEST(StarRecovery, CountsItsWorkAndSolvesAllFieldsWithOneFactorEach)
{
  const auto problem = sampleProblem({2, 2, 2}, "clamped");
  RecoveryScene scene{{&problem.body}, {problem.data}, {}};
  const SceneField field{{&problem.displacement}, {{{2, {}}, {2, {}}}}, false, {}};
  const auto recovery = test::makeRecovery("Star", {{"Sweeps", 2}});
  Ledger ledger;
  const auto stresses = recovery->recover(scene, {field, field}, test::comm(), ledger);
  EXPECT_EQ(ledger.counted("star sweeps"), 2);
  EXPECT_EQ(ledger.counted("stars"), 3 * problem.body.mesh.numPoints());
  const StressCorrection expected = recovered(problem, 2);
  ASSERT_EQ(stresses.size(), 2U);
  for (const SceneStress& stress : stresses) {
    ASSERT_EQ(stress.corrections.size(), 1U);
    EXPECT_LT(test::largest(test::difference(stress.corrections[0].tractions, expected.tractions)),
              roundOff * expected.force);
    EXPECT_LT(stress.corrections[0].defect(), roundOff);
    EXPECT_GT(stress.corrections[0].defect(), 0.0);
  }
}

TEST(StarRecovery, OffersTheOrderOfTheDisplacementsOrOneMore)
{
  EXPECT_EQ(test::makeRecovery("Star")->degree(2), 2);
  EXPECT_EQ(test::makeRecovery("Star", {{"Degree", 3}})->degree(2), 3);
  for (const int degree : {0, 2, 3})
    EXPECT_EQ(test::makeRecovery("Star", {{"Degree", degree}})->refusal(2, 2, true), "");
  EXPECT_EQ(test::makeRecovery("Star", {{"Degree", 1}})->refusal(2, 2, false),
            "Degree = 1 does not suit displacements of order 2 in 2 dimensions; it may be 2 or 3");
  EXPECT_EQ(test::makeRecovery("Star", {{"Degree", 3}})->refusal(3, 2, false),
            "Degree = 3 does not suit displacements of order 2 in 3 dimensions; it may be 2");
  EXPECT_THAT(test::makeRecovery("Star")->refusal(3, 2, true), testing::HasSubstr("choose Type Global"));
}

} // namespace ndframe

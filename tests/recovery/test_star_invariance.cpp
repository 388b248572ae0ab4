#include <cmath>

#include <gtest/gtest.h>

#include "admissibility/sample_problems.hpp"
#include "body_stars.hpp"
#include "common/test_main.hpp"
#include "equilibrium/sample_stress.hpp"

namespace ndframe
{

namespace
{

struct Recovered
{
  StressCorrection correction;
  double energy;
};

Recovered recover(const test::Problem& problem, const Comm& comm, int sweeps)
{
  Ledger ledger;
  BodyStars stars(problem.body, problem.data);
  auto corrections = stars.solve({problem.field()}, comm, ledger);
  for (int sweep = 0; sweep < sweeps; ++sweep)
    stars.sweep(corrections, comm, ledger);
  return {corrections[0], test::energyOf(problem.body, corrections[0])};
}

/// Clamps, rollers and pressures turn with the body.
test::Problem pressed(const test::Space& space, const Mesh& mesh)
{
  test::Conditions conditions{{test::onSide("Clamp", "left"), test::onSide("Roller", "bottom")}, {}};
  for (const auto& [side, value] : {std::pair("right", "0.7"), std::pair("top", "-0.4")}) {
    conditions.loads.push_back(test::onSide("Pressure", side));
    conditions.loads.back().entries.emplace_back("Value", value);
  }
  return test::solved(test::makeBody(mesh, space.order, conditions), space.degree);
}

} // namespace

struct StarInvariance : testing::TestWithParam<test::Space>
{
  test::Problem problem = test::solved(test::makeBody(test::sampleMesh(GetParam().dim, 0.0), GetParam().order,
                                                      test::conditions(GetParam().dim, "corner")),
                                       GetParam().degree);
};

TEST_P(StarInvariance, UnderUnits)
{
  const Recovered before = recover(problem, test::comm(), 1);
  const int dim = GetParam().dim;
  for (const auto& [length, stress] : {std::pair(1e-6, 1e11), std::pair(1e4, 1e-9)}) {
    const double stretch = 1e-3, force = stress * stretch * std::pow(length, dim - 1);
    test::Problem scaled =
        test::solved(test::makeBody(test::sampleMesh(dim, 0.0), GetParam().order, test::conditions(dim, "corner")),
                     GetParam().degree);
    for (double& coordinate : scaled.body.mesh.points)
      coordinate *= length;
    Elasticity law = scaled.body.laws(0);
    for (double& entry : law.D)
      entry *= stress;
    scaled.body.laws = law;
    for (double& u : scaled.displacement)
      u *= stretch * length;
    for (double& share : scaled.data.facetShares)
      share *= force;
    for (double& share : scaled.data.cellShares)
      share *= force;
    const Recovered after = recover(scaled, test::comm(), 1);
    EXPECT_NEAR(after.energy / (force * stretch * length), before.energy, 1e-11 * before.energy);
    EXPECT_LT(after.correction.imbalance, 1e-12 * after.correction.force);
  }
}

TEST_P(StarInvariance, UnderRotation)
{
  const test::Space space = GetParam();
  const auto turn = [](double* x) {
    const double c = std::cos(0.6), s = std::sin(0.6), turned = c * x[0] - s * x[1];
    x[1] = s * x[0] + c * x[1];
    x[0] = turned;
  };
  const Mesh mesh = test::sampleMesh(space.dim, 0.0);
  const double straight = recover(pressed(space, mesh), test::comm(), 1).energy;
  EXPECT_NEAR(recover(pressed(space, test::moved(mesh, turn)), test::comm(), 1).energy, straight, 1e-10 * straight);
}

TEST_P(StarInvariance, UnderRenumbering)
{
  const test::Space space = GetParam();
  const auto bound = [&](const Mesh& mesh) {
    return recover(test::solved(test::makeBody(mesh, space.order, test::conditions(space.dim, "corner")), space.degree),
                   test::comm(), 0)
        .energy;
  };
  const Mesh mesh = test::sampleMesh(space.dim, 0.0);
  const double before = bound(mesh);
  for (const unsigned seed : {1U, 2U})
    EXPECT_NEAR(bound(test::renumbered(mesh, seed)), before, 1e-11 * before);
}

TEST_P(StarInvariance, UnderTheNumberOfRanks)
{
  const Recovered alone = recover(problem, Comm::single(), 2), together = recover(problem, test::comm(), 2);
  const double size = test::largest(alone.correction.tractions);
  EXPECT_LT(test::largest(test::difference(together.correction.tractions, alone.correction.tractions)), 1e-12 * size);
  EXPECT_LT(test::largest(test::difference(together.correction.loads, alone.correction.loads)), 1e-12 * size);
  EXPECT_NEAR(together.correction.force, alone.correction.force, 1e-12 * size);
}

INSTANTIATE_TEST_SUITE_P(AllSpaces, StarInvariance, testing::ValuesIn(test::allSpaces()), test::spaceName);

} // namespace ndframe

#include <gtest/gtest.h>

#include "coupling/sample_systems.hpp"
#include "interface/box_bodies.hpp"
#include "subdomain/sample_problems.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

CouplingResult monolithic(const InterfaceSystem& system)
{
  return run(*makeCoupling(text("Type", "Monolithic")), system);
}

/// Three bodies on top of each other: the middle one is the Neumann body above and the Dirichlet body below.
InterfaceSystem stack(unsigned seed)
{
  InterfaceSystem system = emptySystem(6);
  system.gap = ofUnknowns({0.0, 0.02, 0.0, 0.01, 0.0, 0.03});
  BodyTrace middle = makeBody({0, 1, 2, 3, 4, 5}, true, floatingChain(6), randomNumbers(6, seed), true);
  for (std::size_t k = 0; k < 3; ++k)
    middle.roles[k] = ContactRole::Neumann;
  system.bodies.push_back(makeBody({0, 1, 2}, true, floatingChain(3), {0.7, 1.0, 0.4}, true));
  system.bodies.push_back(std::move(middle));
  system.bodies.push_back(makeBody({3, 4, 5}, false, mildStiffness(3, seed + 1, 1.0), Vector(3, 0.0)));
  for (double& g : system.bodies[1].g)
    g = 0.3 * g + 0.4;
  return system;
}

} // namespace

TEST(Monolithic, FulfilsTheContactConditionsOfTwoBodies)
{
  for (const bool floats : {false, true})
    for (unsigned seed = 0; seed < 40; ++seed) {
      SCOPED_TRACE(testing::Message() << (floats ? "floating" : "held") << ", seed " << seed);
      const auto system = randomSystem(seed, floats);
      const auto result = monolithic(system);
      EXPECT_TRUE(result.converged);
      expectEquilibrium(system, result.state);
      expectComplementarity(system, result.state);
    }
}

TEST(Monolithic, ABodyMayHaveBothRoles)
{
  for (unsigned seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const auto system = stack(seed);
    const auto result = monolithic(system);
    expectEquilibrium(system, result.state);
    expectComplementarity(system, result.state);
  }
}

TEST(Monolithic, HasOneSweepAndNoIterationError)
{
  const auto result = monolithic(patchSystem());
  ASSERT_EQ(result.history.size(), 1u);
  EXPECT_EQ(result.history[0].epsTau, 0.0);
  EXPECT_EQ(result.history[0].theta, 0.0);
  EXPECT_EQ(result.state.tractionDirichlet, result.state.tractionNeumann);
  for (const double traction : result.state.tractionDirichlet)
    EXPECT_NEAR(traction, -1.0, 1e-13);
}

TEST(Monolithic, KnowsNoRoles)
{
  EXPECT_EQ(makeCoupling(text("Type", "Monolithic"))->roles(), Roles::None);
}

TEST(Monolithic, NeumannBodyMayFloatWhenContactHoldsIt)
{
  // The block below floats and is pressed up against the held one.
  InterfaceSystem system = emptySystem(4);
  system.bodies.push_back(makeBody({0, 1, 2, 3}, true, mildStiffness(4, 1, 1.0), Vector(4, 0.0)));
  system.bodies.push_back(makeBody({0, 1, 2, 3}, false, floatingChain(4), {-1.0, -0.2, -0.3, -1.0}, true));
  const auto result = monolithic(system);
  expectEquilibrium(system, result.state);
  expectComplementarity(system, result.state);
  EXPECT_NEAR(result.history[0].forceDirichlet, -2.5, 1e-13);
}

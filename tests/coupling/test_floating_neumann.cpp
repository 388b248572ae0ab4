#include <algorithm>
#include <cmath>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "coupling/sample_systems.hpp"
#include "interface/box_bodies.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "subdomain/sample_problems.hpp"

using namespace ndframe;
using namespace ndframe::test;
using testing::HasSubstr;

namespace
{

InterfaceState together(const InterfaceSystem& system)
{
  return run(*makeCoupling(text("Type", "Monolithic")), system).state;
}

double sum(const Vector& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// The patch test upside down: the block is the Neumann body.
InterfaceSystem patchBelow()
{
  return exchanged(patchSystem());
}

} // namespace

TEST(FloatingNeumannBody, IsPlacedAsTheMonolithicSolutionPlacesIt)
{
  int partial = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const auto system = floatingNeumannSystem(seed);
    const auto result = run(*neumannDirichlet(1e-12), system);
    EXPECT_TRUE(result.converged) << result.reason;
    expectSameState(result.state, together(system), 1e-10);
    const auto closed = std::count(result.state.closed.begin(), result.state.closed.end(), char(1));
    partial += closed > 0 && closed < std::ptrdiff_t(result.state.closed.size());
  }
  EXPECT_GE(partial, 20) << "contact is hardly ever lost: choose other seeds";
}

TEST(FloatingNeumannBody, IsInEquilibriumWithItsTractionInEverySweep)
{
  for (unsigned seed = 0; seed < 20; ++seed) {
    const auto system = floatingNeumannSystem(seed);
    for (const int sweeps : {1, 2, 3}) {
      const auto result = run(*neumannDirichlet(1e-14, {}, sweeps), system);
      expectEquilibrium(system, result.state);
      expectComplementarity(system, result.state);
      EXPECT_NEAR(sum(result.state.forceDirichlet), sum(system.bodies[1].g), 1e-12);
      EXPECT_NEAR(sum(result.state.forceNeumann), sum(system.bodies[1].g), 1e-12);
    }
  }
}

TEST(FloatingNeumannBody, EndsThePatchAfterOneSweep)
{
  // The start that balances the block's load is the answer.
  const auto result = run(*neumannDirichlet(1e-8), patchBelow());
  EXPECT_TRUE(result.converged);
  ASSERT_EQ(result.history.size(), 1u);
  for (const double traction : result.state.tractionDirichlet)
    EXPECT_NEAR(traction, -1.0, 1e-12);
}

TEST(FloatingNeumannBody, MayBePressedAgainstAFloatingBodyWithAnotherFreeMotion)
{
  // Two unconnected halves of an interface: on each one body floats.
  const auto system = sideBySide(floatingNeumannSystem(3), randomSystem(5, true));
  for (const char* start : {"Zero", "Balanced"}) {
    const auto result = run(*neumannDirichlet(1e-12, text("Initial Traction", start)), system);
    EXPECT_TRUE(result.converged) << result.reason;
    expectSameState(result.state, together(system), 1e-10);
  }
}

TEST(FloatingNeumannBody, DoesNotDependOnHowTheOperatorsAreRepresented)
{
  const auto stored = floatingNeumannSystem(7);
  auto applied = stored;
  for (auto& body : applied.bodies)
    body.S = appliedOnly(*body.S->dense());
  expectSameState(run(*neumannDirichlet(1e-11), applied).state, run(*neumannDirichlet(1e-11), stored).state, 1e-9);
}

TEST(FloatingNeumannBody, ThatIsPulledOffIsNamed)
{
  auto system = patchBelow();
  for (double& g : system.bodies[0].g)
    g = -g;
  try {
    run(*neumannDirichlet(1e-8), system);
    ADD_FAILURE();
  } catch (const NotConverged& failure) {
    EXPECT_THAT(failure.what(), HasSubstr("nothing stops translation along y"));
  }
}

TEST(FloatingNeumannBody, UnitsChangeNeitherStatusesNorSweeps)
{
  for (unsigned seed = 0; seed < 10; ++seed) {
    const auto system = floatingNeumannSystem(seed);
    const auto scaled = inOtherUnits(system, 1e9, 1e-3);
    const auto plain = run(*neumannDirichlet(1e-6), system), other = run(*neumannDirichlet(1e-6), scaled);
    EXPECT_EQ(other.state.closed, plain.state.closed);
    EXPECT_EQ(other.history.size(), plain.history.size());
  }
}

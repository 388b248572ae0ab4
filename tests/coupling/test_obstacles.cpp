#include <gtest/gtest.h>

#include "interface/box_bodies.hpp"
#include "ndframe/algebra/dense.hpp"
#include "sample_systems.hpp"

namespace ndframe::test
{
namespace
{

/// Every obstacle as a body of its own that hardly gives way.
InterfaceSystem withStiffBodies(InterfaceSystem system, double stiffness)
{
  for (int i = 0; i < system.size(); ++i)
    if (system.isObstacle[std::size_t(i)]) {
      DenseMatrix S(1, 1);
      S(0, 0) = stiffness;
      system.bodies.push_back(makeBody({i}, false, S, {stiffness * system.obstacle[std::size_t(i)]}));
      system.isObstacle[std::size_t(i)] = 0;
      system.obstacle[std::size_t(i)] = 0.0;
    }
  return system;
}

void expectSame(const Vector& a, const Vector& b, double tolerance)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_NEAR(a[i], b[i], tolerance) << "entry " << i;
}

} // namespace

TEST(Obstacles, AreBodiesThatDoNotGiveWay)
{
  int met = 0, left = 0;
  for (unsigned seed = 0; seed < 40; ++seed)
    for (const bool floats : {false, true}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << (floats ? ", floating" : ""));
      const auto system = obstacleSystem(seed, floats);
      const auto state = run(*makeCoupling(text("Type", "Monolithic")), system).state;
      expectEquilibrium(system, state);
      expectComplementarity(system, state);
      const auto stiff = run(*makeCoupling(text("Type", "Monolithic")), withStiffBodies(system, 1e9)).state;
      expectSame(state.uDirichlet, stiff.uDirichlet, 1e-7);
      expectSame(state.forceDirichlet, stiff.forceDirichlet, 1e-7);
      EXPECT_EQ(state.closed, stiff.closed);
      (state.closed.front() ? met : left) += 1;
    }
  EXPECT_GT(met, 10);
  EXPECT_GT(left, 10);
}

TEST(Obstacles, AreMetByTheIterationAsByAllBodiesTogether)
{
  for (unsigned seed = 0; seed < 40; ++seed)
    for (const bool floats : {false, true}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << (floats ? ", floating" : ""));
      const auto system = obstacleSystem(seed, floats);
      const auto together = run(*makeCoupling(text("Type", "Monolithic")), system).state;
      const auto result = run(*neumannDirichlet(1e-12), system);
      EXPECT_TRUE(result.converged) << result.reason;
      expectEquilibrium(system, result.state);
      expectComplementarity(system, result.state);
      expectSame(result.state.uDirichlet, together.uDirichlet, 1e-9);
      expectSame(result.state.uNeumann, together.uNeumann, 1e-9);
      expectSame(result.state.forceDirichlet, together.forceDirichlet, 1e-9);
    }
}

} // namespace ndframe::test

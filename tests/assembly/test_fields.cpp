#include <gtest/gtest.h>

#include "assembly/sample_body.hpp"
#include "common/test_main.hpp"
#include "ndframe/assembly/fields.hpp"

namespace ndframe
{

namespace
{

constexpr double nu = 0.3, young = 2.0, mu = young / (2 * (1 + nu)), lambda = young * nu / ((1 + nu) * (1 - 2 * nu));

Mesh plane()
{
  return test::shaken(test::box({4, 3}, "Alternating", 0.0, {2.0, 1.0}), 0.05, 1);
}
Mesh space()
{
  return test::shaken(test::box({2, 2, 2}, "Alternating", 0.0, {2.0, 1.0, 1.0}), 0.05, 1);
}

void expectStress(const std::array<double, 6>& computed, const std::array<double, 6>& exact)
{
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(computed[i], exact[i], 1e-12) << "component " << i;
}

/// u = (0.1 x + 0.3 y, 0.2 y, 0)
void stretchAndShear(const double* x, double* u)
{
  u[0] = 0.1 * x[0] + 0.3 * x[1];
  u[1] = 0.2 * x[1];
}

double energyOf(const BodyModel& body, const std::function<void(const double*, double*)>& field)
{
  return energy(body, test::interpolate(body.nodes, field));
}

} // namespace

struct Fields : testing::TestWithParam<int>
{
  int order = GetParam();
};
INSTANTIATE_TEST_SUITE_P(Orders, Fields, testing::Values(1, 2), testing::PrintToStringParamName());

TEST_P(Fields, StressOfALinearFieldInPlaneStrain)
{
  const BodyModel body = test::makeBody(plane(), order);
  const auto stresses = cellStress(body, test::interpolate(body.nodes, stretchAndShear));
  ASSERT_EQ(int(stresses.size()), body.mesh.numCells());
  for (const auto& stress : stresses)
    expectStress(stress, {lambda * 0.3 + mu * 0.2, lambda * 0.3 + mu * 0.4, lambda * 0.3, mu * 0.3, 0, 0});
}

TEST_P(Fields, StressOfALinearFieldInPlaneStress)
{
  BodyModel body = test::makeBody(plane(), order);
  body.laws = test::elastic(2, Hypothesis::PlaneStress);
  const double E = young / (1 - nu * nu);
  for (const auto& stress : cellStress(body, test::interpolate(body.nodes, stretchAndShear)))
    expectStress(stress, {E * (0.1 + nu * 0.2), E * (0.2 + nu * 0.1), 0, mu * 0.3, 0, 0});
}

TEST_P(Fields, StressOfALinearFieldInSpace)
{
  const BodyModel body = test::makeBody(space(), order);
  const auto u = test::interpolate(body.nodes, [](const double* x, double* value) {
    value[0] = 0.1 * x[0] + 0.2 * x[2];
    value[1] = 0.4 * x[2];
    value[2] = -0.3 * x[2] + 0.5 * x[0];
  });
  const double trace = lambda * -0.2;
  for (const auto& stress : cellStress(body, u))
    expectStress(stress, {trace + mu * 0.2, trace, trace - mu * 0.6, 0.0, mu * 0.4, mu * 0.7});
}

TEST_P(Fields, RigidMotionsHaveNoStress)
{
  const BodyModel body = test::makeBody(plane(), order);
  const auto u = test::interpolate(body.nodes, [](const double* x, double* value) {
    value[0] = 0.5 - 0.3 * x[1];
    value[1] = 0.2 + 0.3 * x[0];
  });
  for (const auto& stress : cellStress(body, u))
    expectStress(stress, {});
}

TEST(FieldsOfOrderTwo, StressOfAQuadraticFieldIsThatOfTheCentroid)
{
  const BodyModel body = test::makeBody(plane(), 2);
  const auto stresses = cellStress(body, test::interpolate(body.nodes, [](const double* x, double* u) {
                                     u[0] = x[0] * x[0];
                                     u[1] = x[0] * x[1];
                                   }));
  for (int c = 0; c < body.mesh.numCells(); ++c) {
    double x = 0.0, y = 0.0;
    for (int v = 0; v < 3; ++v) {
      x += body.mesh.point(body.mesh.cell(c)[v])[0] / 3.0;
      y += body.mesh.point(body.mesh.cell(c)[v])[1] / 3.0;
    }
    // eps = (2x, x, y)
    expectStress(stresses[std::size_t(c)],
                 {(3 * lambda + 4 * mu) * x, (3 * lambda + 2 * mu) * x, 3 * lambda * x, mu * y, 0, 0});
  }
}

TEST_P(Fields, EnergyOfALinearFieldIsStressTimesStrainTimesVolume)
{
  // The area is 2; no factor 1/2.
  const double perArea = lambda * 0.09 + 2 * mu * (0.01 + 0.04) + mu * 0.09;
  EXPECT_NEAR(energyOf(test::makeBody(plane(), order), stretchAndShear), 2.0 * perArea, 1e-13);
  const auto stretch = [](const double* x, double* u) { u[0] = 0.1 * x[0], u[1] = u[2] = 0.0; };
  EXPECT_NEAR(energyOf(test::makeBody(space(), order), stretch), 2.0 * 0.01 * (lambda + 2 * mu), 1e-13);
}

TEST_P(Fields, ALargeRigidMotionDoesNotDrownTheEnergy)
{
  const auto field = [](const double* x, double* u) { u[0] = 1.0 + 1e-8 * x[0], u[1] = 1.0; };
  const double exact = 2.0 * 1e-16 * (lambda + 2 * mu);
  EXPECT_NEAR(energyOf(test::makeBody(plane(), order), field), exact, 1e-6 * exact);
}

TEST(FieldsOfOrderTwo, EnergyOfAQuadraticFieldIsItsIntegral)
{
  const auto field = [](const double* x, double* u) { u[0] = x[0] * x[0], u[1] = x[0] * x[1]; };
  // eps = (2x, x, y): int 9 lambda x^2 + 10 mu x^2 + mu y^2 over 2 x 1, int x^2 = 8/3, int y^2 = 2/3
  const double exact = (9 * lambda + 10 * mu) * 8.0 / 3.0 + mu * 2.0 / 3.0;
  EXPECT_NEAR(energyOf(test::makeBody(plane(), 2), field), exact, 1e-12 * exact);
}

} // namespace ndframe

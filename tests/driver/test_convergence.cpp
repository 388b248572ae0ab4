// Known limits: mesh convergence of the paper's two examples, Hertz's closed form, pure bending.

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "driver/scene.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

RunSummary together(Scene& scene)
{
  return scene.set("Coupling/Type=Monolithic").run().run.summary;
}

/// Cells per unit length n.
RunSummary punch(int n)
{
  Scene scene("punch");
  scene.set(fmt::format("Bodies/punch/Mesh/Cells={{{0}, {0}}}", n));
  return together(scene.set(fmt::format("Bodies/foundation/Mesh/Cells={{{}, {}}}", 2 * n, n)));
}

/// n divisible by 10.
RunSummary contactLoss(int n)
{
  Scene scene("contact-loss");
  scene.set(fmt::format("Bodies/upper/Mesh/Cells={{{}, {}}}", n, 8 * n / 10));
  return together(scene.set(fmt::format("Bodies/lower/Mesh/Cells={{{0}, {0}}}", 2 * n)));
}

/// The limit of a, b, c when the distance to it falls by the same factor each time.
double extrapolated(double a, double b, double c)
{
  return c + (c - b) * (c - b) / ((b - a) - (c - b));
}

} // namespace

TEST(Punch, EnergyGrowsToItsLimitWithTheOrderOfTheCorner)
{
  const double E[] = {punch(8).energy, punch(16).energy, punch(32).energy, punch(64).energy};
  for (int k = 0; k < 3; ++k)
    EXPECT_LT(E[k], E[k + 1]);
  EXPECT_LT(E[3], 1.60075);
  // The singularity u ~ r^0.774 at the edge of the punch: the energy's error is of order h^1.548.
  EXPECT_NEAR(std::log2((E[2] - E[1]) / (E[3] - E[2])), 1.55, 0.03);
  EXPECT_NEAR(extrapolated(E[1], E[2], E[3]), 1.60075, 2e-4);
}

TEST(ContactLoss, EnergyGrowsToItsLimit)
{
  const double E[] = {contactLoss(10).energy, contactLoss(20).energy, contactLoss(40).energy};
  EXPECT_LT(E[0], E[1]);
  EXPECT_LT(E[1], E[2]);
  EXPECT_NEAR(E[2], 0.35001, 2e-4);
}

TEST(ContactLoss, ContactEndsWithinOneElementOfItsLimit)
{
  for (const int n : {10, 20, 40}) {
    const auto contact = contactLoss(n).interfaces.front();
    ASSERT_EQ(contact.endPoints.size(), 2U);
    EXPECT_NEAR(contact.endPoints[1][0], 0.957, 1.0 / n) << n;
    EXPECT_NEAR(contact.contactMeasure, 0.957, 1.0 / n) << n;
    EXPECT_NEAR(contact.contactForce, 0.5, 1e-10) << n;
  }
}

TEST(Hertz, MeetsTheClosedFormWithinTwoPercentOnGradedMeshes)
{
  for (const char* cells : {"48, 24", "60, 28"}) {
    Scene scene("hertz");
    for (const char* body : {"cylinder", "block"})
      scene.set(fmt::format("Bodies/{}/Mesh/Cells={{{}}}", body, cells));
    const auto contact = scene.run().run.summary.interfaces.front();
    EXPECT_NEAR(contact.largestPressure / 0.013736, 1.0, 0.02) << cells;
    EXPECT_NEAR(contact.contactMeasure / 0.05, 1.0, 0.02) << cells;
    EXPECT_NEAR(contact.contactForce, 5.394e-4, 1e-12) << cells;
  }
}

/// p(x) = p0 sqrt(1 - (x/a)^2) along the whole contact, away from its end.
TEST(Hertz, PressureFollowsTheEllipse)
{
  const auto outcome = Scene("hertz").run();
  int compared = 0;
  for (const auto& node : outcome.run.solved.contact)
    if (const double x = node.point[0] / 0.05; x < 0.9) {
      EXPECT_NEAR(-node.tractionDirichlet, 0.013736 * std::sqrt(1 - x * x), 0.02 * 0.013736) << x;
      ++compared;
    }
  EXPECT_GT(compared, 20);
}

/// u = k (x y, -(x^2 + nu (y^2 - z^2)) / 2, -nu y z) with k = 0.01, nu = 0.3.
TEST(Beam, IsExactWithQuadraticElements)
{
  const auto outcome = Scene("beam-3d").run();
  const auto& nodes = outcome.run.model.bodies[0].nodes;
  Vector exact;
  for (int i = 0; i < nodes.numNodes(); ++i) {
    const double x = nodes.point(i)[0], y = nodes.point(i)[1], z = nodes.point(i)[2];
    exact.insert(exact.end(), {0.01 * x * y, -0.005 * (x * x + 0.3 * (y * y - z * z)), -0.003 * y * z});
  }
  EXPECT_LT(relativeDifference(displacement(outcome.run, 0), exact), 1e-11);
  EXPECT_NEAR(outcome.run.summary.energy * 600, 1.0, 1e-11);
  EXPECT_LT(outcome.run.summary.residuals.equilibrium, 1e-11);
}

TEST(Beam, ConvergesWithLinearElements)
{
  double error[3];
  for (int k = 0; k < 3; ++k) {
    const int n = 1 << k;
    error[k] = 1.0 / 600 - Scene("beam-3d")
                               .set("Discretization/Order=1")
                               .set(fmt::format("Bodies/beam/Mesh/Cells={{{}, {}, {}}}", 16 * n, 4 * n, 2 * n))
                               .run()
                               .run.summary.energy;
  }
  EXPECT_GT(error[2], 0.0);
  EXPECT_NEAR(std::log2(error[1] / error[2]), 2.0, 0.3);
  EXPECT_LT(error[1], error[0]);
}

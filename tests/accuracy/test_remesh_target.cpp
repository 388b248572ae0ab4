// Runs with a target on meshes that gmsh makes anew: curved geometry is followed.

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "driver/scene.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

Scene toTarget(Scene scene, const std::string& target, const std::string& refinement)
{
  return scene.set("Accuracy/Target=" + target)
      .set("Accuracy/Refinement/Type=" + refinement)
      .set("Error Estimation/Estimators={Global}");
}

/// Two rings that touch on an arc, beginning with eight facets there.
Scene rings()
{
  return Scene("rings").set("Bodies/outer/Mesh/Mesh Size Factor=8").set("Bodies/inner/Mesh/Mesh Size Factor=8");
}

Scene hole()
{
  return Scene::fromFile(NDFRAME_ACCURACY_SCENES "/hole.xml").set("Coupling/Initial Traction=Balanced");
}

double largestPressure(const Run& run)
{
  double largest = 0.0;
  for (const double pressure : traction(run))
    largest = std::max(largest, -pressure);
  return largest;
}

std::int64_t dofsTo(const std::string& target, const std::string& refinement)
{
  const auto outcome = toTarget(hole(), target, refinement).run();
  EXPECT_TRUE(outcome.run.summary.accuracy->reached);
  return outcome.run.summary.accuracy->levels.back().dofs;
}

} // namespace

TEST(RemeshTarget, CurvedContactConvergesToLame)
{
  const auto outcome = toTarget(rings(), "0.002", "Remesh").run();
  EXPECT_TRUE(outcome.run.summary.accuracy->reached);
  EXPECT_NEAR(largestPressure(outcome.run), 27.0 / 32.0, 1e-3);
}

TEST(RemeshTarget, BisectionStaysOnTheFirstPolygon)
{
  const auto outcome = toTarget(rings(), "0.01", "Bisection").run();
  EXPECT_TRUE(outcome.run.summary.accuracy->reached);
  EXPECT_GT(std::abs(largestPressure(outcome.run) - 27.0 / 32.0), 1e-2);
}

TEST(RemeshTarget, AHoleTakesFewerDofsThanThePolygonInItsPlace)
{
  EXPECT_LT(double(dofsTo("0.01", "Remesh")), 0.8 * double(dofsTo("0.01", "Bisection")));
}

TEST(RemeshTarget, TheBoundFallsLikeTheBestMeshes)
{
  const auto outcome = toTarget(hole(), "0.003", "Remesh").run();
  const auto& levels = outcome.run.summary.accuracy->levels;
  const double slope = std::log(levels.back().bound / levels.front().bound) /
                       std::log(double(levels.back().dofs) / double(levels.front().dofs));
  EXPECT_LE(slope, -0.95);
}

TEST(RemeshTarget, BoxesAreRefused)
{
  const std::string complaint = complaintOf(toTarget(Scene("punch"), "0.01", "Remesh"));
  EXPECT_NE(complaint.find("Bodies/punch/Mesh"), std::string::npos) << complaint;
  EXPECT_NE(complaint.find("refine by Bisection"), std::string::npos) << complaint;
}

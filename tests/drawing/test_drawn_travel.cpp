// How far a body is moved until it touches.

#include <gtest/gtest.h>

#include <cmath>

#include "drawing/drawn_squares.hpp"
#include "drawn_travel.hpp"

using namespace ndframe;
using namespace ndframe::test;

TEST(DrawnTravel, IsTheGapAlongTheNormal)
{
  const DrawnAssembly scene = blockOnPlate(0.25);
  EXPECT_DOUBLE_EQ(travelUntilContact(scene, scene.contacts[0], 1, {0.0, -1.0, 0.0}).value(), 0.25);
  EXPECT_DOUBLE_EQ(travelUntilContact(scene, scene.contacts[0], 0, {0.0, 1.0, 0.0}).value(), 0.25);
}

TEST(DrawnTravel, IsLongerAlongAnInclinedWay)
{
  const DrawnAssembly scene = blockOnPlate(0.25);
  const double half = std::sqrt(0.5);
  EXPECT_NEAR(travelUntilContact(scene, scene.contacts[0], 1, {half, -half, 0.0}).value(), 0.25 / half, 1e-15);
}

TEST(DrawnTravel, ChordsThatOverlapTouchAlready)
{
  const DrawnAssembly scene = blockOnPlate(-0.01);
  EXPECT_DOUBLE_EQ(travelUntilContact(scene, scene.contacts[0], 1, {0.0, -1.0, 0.0}).value(), 0.0);
}

TEST(DrawnTravel, EndsNowhereWhereSidesPassOrLookAway)
{
  const DrawnAssembly beside = blockOnPlate(0.25, 3.0), above = blockOnPlate(0.25);
  EXPECT_FALSE(travelUntilContact(beside, beside.contacts[0], 1, {0.0, -1.0, 0.0}));
  EXPECT_FALSE(travelUntilContact(above, above.contacts[0], 1, {0.0, 1.0, 0.0}));
  EXPECT_FALSE(travelUntilContact(above, above.contacts[0], 1, {1.0, 0.0, 0.0}));
}

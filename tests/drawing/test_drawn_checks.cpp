// What a drawing must not be.

#include <gmock/gmock.h>

#include "drawing/drawn_squares.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/drawing/drawn_checks.hpp"

using namespace ndframe;
using namespace ndframe::test;
using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(DrawnChecks, FindWhereBodiesOverlap)
{
  EXPECT_FALSE(overlapOf(blockOnPlate(0.0)));
  const auto overlap = overlapOf(blockOnPlate(-0.5));
  ASSERT_TRUE(overlap);
  EXPECT_EQ(overlap->first + overlap->second, "plateblock");
  EXPECT_LT(overlap->place[1], 0.0);
}

TEST(DrawnChecks, RefuseBodiesOfSeveralParts)
{
  DrawnAssembly scene = blockOnPlate(0.5);
  EXPECT_NO_THROW(refuseUnconnectedParts(scene));
  Mesh& mesh = scene.bodies[0].mesh;
  mesh.points.insert(mesh.points.end(), {5.0, 0.0, 6.0, 0.0, 5.0, 1.0});
  mesh.cells.insert(mesh.cells.end(), {4, 5, 6});
  EXPECT_THAT([&] { refuseUnconnectedParts(scene); },
              ThrowsMessage<InputError>(HasSubstr("\"plate\" has 2 parts that share no edge, at (")));
}

TEST(DrawnChecks, RefuseNamesWithCommasAndBraces)
{
  EXPECT_NO_THROW(refuseNamesOfLists({"plate & <co>", "Größe"}));
  for (const char* name : {"a, b", "{a}"})
    EXPECT_THROW(refuseNamesOfLists({"plate", name}), InputError);
}

TEST(DrawnChecks, RefuseBodiesWithoutANamedSide)
{
  DrawnAssembly scene = blockOnPlate(0.5);
  scene.bodies[0].sides.clear();
  EXPECT_NO_THROW(refuseNamelessSides(scene));
  scene.bodies[1].sides.clear();
  EXPECT_THAT([&] { refuseNamelessSides(scene); },
              ThrowsMessage<InputError>(HasSubstr("no side has a name: write Physical Curve(\"table\") = {3};")));
}

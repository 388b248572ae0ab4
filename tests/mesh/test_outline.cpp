// What a body is apart from how it is meshed.

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "meshing/mesh_deck.hpp"
#include "ndframe/mesh/outline.hpp"
#include "ndframe/mesh/refine.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

Mesh square(const std::string& cells, const std::string& degrees = "17")
{
  return readMesh(text("Type", "Box") + doubles("Lower", "0.3, 0.1") + doubles("Upper", "1.3, 1.1") +
                  ints("Cells", cells) + number("Rotation", degrees));
}

Mesh cube(const std::string& cells)
{
  return readMesh(text("Type", "Box") + doubles("Lower", "0, 0, 0") + doubles("Upper", "1, 1, 1") +
                  ints("Cells", cells));
}

/// The top is cut in two.
Mesh split(const std::string& at)
{
  return readMesh(text("Type", "Box") + doubles("Lower", "0, 0") + doubles("Upper", "1, 1") + ints("Cells", "10, 2") +
                  list("Splits", list("one", text("Side", "top") + doubles("At", at) + strings("Names", "a, b"))));
}

Mesh moved(Mesh mesh, const std::function<void(double*)>& move)
{
  for (int i = 0; i < mesh.numPoints(); ++i)
    move(mesh.points.data() + i * mesh.dim);
  return mesh;
}

/// The side y = 1.1 of the square, not turned, becomes an arc.
void bend(double* p)
{
  p[1] += 0.1 * (p[1] - 0.1) * (p[0] - 0.3) * (1.3 - p[0]);
}

/// The square with the cells left of x = `at` in a group.
Mesh withGroup(const std::string& cells, double at)
{
  Mesh mesh = square(cells, "0");
  for (int c = 0; c < mesh.numCells(); ++c)
    mesh.groups.kind.push_back(mesh.groups.findOrAdd(cellCentre(mesh, c)[0] < at ? std::vector<std::string>{"left half"}
                                                                                 : std::vector<std::string>{}));
  return mesh;
}

TEST(Outline, KnowsGroupsOfCells)
{
  const MeshOutline coarse = outlineOf(withGroup("4, 4", 0.8));
  EXPECT_TRUE(sameOutline(coarse, outlineOf(withGroup("8, 6", 0.8))));
  EXPECT_FALSE(sameOutline(coarse, outlineOf(withGroup("4, 4", 0.55))));
  EXPECT_FALSE(sameOutline(coarse, outlineOf(square("4, 4", "0"))));
}

} // namespace

TEST(Outline, OfASquareHasTwoCornersASide)
{
  for (const auto& [name, side] : outlineOf(square("5, 3")).sides) {
    EXPECT_EQ(side.corners.size(), 4u) << name;
    EXPECT_NEAR(side.measure, 1.0, 1e-14) << name;
  }
}

TEST(Outline, OfACubeHasFourCornersASide)
{
  for (const auto& [name, side] : outlineOf(cube("3, 2, 4")).sides) {
    EXPECT_EQ(side.corners.size(), 12u) << name;
    EXPECT_NEAR(side.measure, 1.0, 1e-14) << name;
  }
}

TEST(Outline, DoesNotDependOnTheMesh)
{
  const MeshOutline coarse = outlineOf(square("1, 1"));
  EXPECT_TRUE(sameOutline(coarse, outlineOf(square("7, 13"))));
  EXPECT_TRUE(sameOutline(coarse, outlineOf(refineUniformly(square("3, 3")))));
  EXPECT_TRUE(sameOutline(outlineOf(cube("1, 1, 1")), outlineOf(cube("3, 2, 5"))));
}

TEST(Outline, SeesAnotherPolygon)
{
  const Mesh three = square("3, 2", "0"), six = square("6, 2", "0");
  EXPECT_TRUE(sameOutline(outlineOf(three), outlineOf(six)));
  EXPECT_FALSE(sameOutline(outlineOf(moved(three, bend)), outlineOf(moved(six, bend))));
  EXPECT_FALSE(sameOutline(outlineOf(three), outlineOf(moved(three, bend))));
  EXPECT_TRUE(sameOutline(outlineOf(moved(three, bend)), outlineOf(refineUniformly(moved(three, bend)))));
}

TEST(Outline, SeesSidesThatEndElsewhere)
{
  EXPECT_TRUE(sameOutline(outlineOf(split("0.3")), outlineOf(split("0.3"))));
  EXPECT_FALSE(sameOutline(outlineOf(split("0.3")), outlineOf(split("0.4"))));
}

TEST(Outline, SeesABodyMovedOrOfAnotherSize)
{
  const Mesh one = square("2, 2");
  EXPECT_FALSE(sameOutline(outlineOf(one), outlineOf(moved(one, [](double* p) { p[0] += 1e-9; }))));
  EXPECT_FALSE(sameOutline(outlineOf(one), outlineOf(moved(one, [](double* p) { p[1] *= 1.0 + 1e-9; }))));
}

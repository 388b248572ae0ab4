#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "meshing/mesh_deck.hpp"

namespace
{

using namespace ndframe;
using namespace ndframe::test;

std::string plane(const std::string& more = {})
{
  return text("Type", "Box") + doubles("Lower", "-1, 0.5") + doubles("Upper", "2, 1.5") + ints("Cells", "7, 4") + more;
}

std::string space(const std::string& more = {})
{
  return text("Type", "Box") + doubles("Lower", "0, 0, 0") + doubles("Upper", "3, 2, 1") + ints("Cells", "4, 3, 2") +
         more;
}

/// The increasing x coordinates of the points at the bottom.
std::vector<double> linesAlongX(const Mesh& mesh, int cells)
{
  std::vector<double> lines;
  for (int p = 0; p <= cells; ++p)
    lines.push_back(mesh.point(p)[0]);
  return lines;
}

struct Variant
{
  const char* name;
  std::string entries;
  int cells;
  double volume;
};

class BoxVariants : public testing::TestWithParam<Variant>
{};

TEST_P(BoxVariants, CellsFillTheBox)
{
  const Mesh mesh = readMesh(GetParam().entries);
  EXPECT_EQ(mesh.numCells(), GetParam().cells);
  EXPECT_NEAR(volume(mesh), GetParam().volume, 1e-13 * GetParam().volume);
}

TEST_P(BoxVariants, BoundaryIsClosed)
{
  EXPECT_LT(boundaryDefect(readMesh(GetParam().entries)), 1e-14);
}

TEST_P(BoxVariants, SidesCoverTheBoundary)
{
  const Mesh mesh = readMesh(GetParam().entries);
  const std::vector<double> sizes =
      mesh.dim == 2 ? std::vector<double>{1, 1, 3, 3} : std::vector<double>{2, 2, 3, 3, 6, 6};
  ASSERT_EQ(mesh.sides.size(), sizes.size());
  for (std::size_t s = 0; s < sizes.size(); ++s)
    EXPECT_NEAR(measure(mesh, mesh.sides[s]), sizes[s], 1e-14 * sizes[s]) << mesh.sides[s].name;
}

INSTANTIATE_TEST_SUITE_P(
    All, BoxVariants,
    testing::Values(
        Variant{"Right", plane(), 56, 3.0}, Variant{"Alternating", plane(text("Pattern", "Alternating")), 56, 3.0},
        Variant{"Crossed", plane(text("Pattern", "Crossed")), 112, 3.0},
        Variant{"Graded", plane(doubles("Grading", "0.1, 20")), 56, 3.0},
        Variant{"Turned", plane(text("Pattern", "Crossed") + number("Rotation", "30")), 112, 3.0},
        Variant{"Kuhn", space(), 144, 6.0}, Variant{"Corners", space(text("Pattern", "Alternating")), 120, 6.0},
        Variant{"TurnedSpace", space(doubles("Grading", "1, 3, 0.2") + number("Rotation", "-75")), 144, 6.0}),
    [](const auto& variant) { return variant.param.name; });

TEST(Box, SidesLieWhereTheirNamesSay)
{
  const Mesh flat = readMesh(plane());
  const double x[] = {1, 0, 0};
  const double y[] = {0, 1, 0};
  const double z[] = {0, 0, 1};
  EXPECT_EQ(distanceFromPlane(flat, *flat.findSide("left"), x, -1.0), 0.0);
  EXPECT_EQ(distanceFromPlane(flat, *flat.findSide("right"), x, 2.0), 0.0);
  EXPECT_EQ(distanceFromPlane(flat, *flat.findSide("bottom"), y, 0.5), 0.0);
  EXPECT_EQ(distanceFromPlane(flat, *flat.findSide("top"), y, 1.5), 0.0);
  const Mesh solid = readMesh(space());
  EXPECT_EQ(distanceFromPlane(solid, *solid.findSide("left"), x, 0.0), 0.0);
  EXPECT_EQ(distanceFromPlane(solid, *solid.findSide("right"), x, 3.0), 0.0);
  EXPECT_EQ(distanceFromPlane(solid, *solid.findSide("front"), y, 0.0), 0.0);
  EXPECT_EQ(distanceFromPlane(solid, *solid.findSide("back"), y, 2.0), 0.0);
  EXPECT_EQ(distanceFromPlane(solid, *solid.findSide("bottom"), z, 0.0), 0.0);
  EXPECT_EQ(distanceFromPlane(solid, *solid.findSide("top"), z, 1.0), 0.0);
}

TEST(Box, RotationTurnsAboutTheOrigin)
{
  const Mesh straight = readMesh(plane());
  const Mesh turned = readMesh(plane(number("Rotation", "30")));
  EXPECT_EQ(straight.cells, turned.cells);
  const double c = std::sqrt(3.0) / 2;
  for (int p = 0; p < straight.numPoints(); ++p) {
    EXPECT_NEAR(turned.point(p)[0], c * straight.point(p)[0] - 0.5 * straight.point(p)[1], 1e-15);
    EXPECT_NEAR(turned.point(p)[1], 0.5 * straight.point(p)[0] + c * straight.point(p)[1], 1e-15);
  }
}

TEST(Box, GradingIsGeometricWithTheGivenRatio)
{
  const std::vector<double> x = linesAlongX(readMesh(plane(doubles("Grading", "0.05, 1"))), 7);
  EXPECT_EQ(x.front(), -1.0);
  EXPECT_EQ(x.back(), 2.0);
  EXPECT_NEAR((x[7] - x[6]) / (x[1] - x[0]), 0.05, 1e-13);
  for (int i = 1; i < 7; ++i)
    EXPECT_NEAR((x[i + 1] - x[i]) / (x[i] - x[i - 1]), std::pow(0.05, 1.0 / 6), 1e-12);
}

TEST(Box, CellSizesFollowTheProfile)
{
  const std::string sizes = list("Cell Sizes X", doubles("At", "0, 1, 3") + doubles("Size", "1, 0.1, 1"));
  const Mesh mesh = readMesh(text("Type", "Box") + doubles("Lower", "0, 0") + doubles("Upper", "3, 1") +
                             ints("Cells", "60, 1") + sizes);
  const std::vector<double> x = linesAlongX(mesh, 60);
  double lowest = 1e9;
  double highest = 0.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = (x[i] + x[i + 1]) / 2;
    const double wanted = middle < 1.0 ? 1.0 - 0.9 * middle : 0.1 + 0.45 * (middle - 1.0);
    lowest = std::min(lowest, (x[i + 1] - x[i]) / wanted);
    highest = std::max(highest, (x[i + 1] - x[i]) / wanted);
  }
  EXPECT_LT(highest / lowest, 1.02); // the same factor everywhere, up to the kink inside a cell
}

TEST(Box, SplitPointsAreGridLinesAndTheNumberOfCellsStays)
{
  const std::string split = text("Side", "top") + doubles("At", "0.1, 1.7") + strings("Names", "a, b, c");
  const Mesh mesh = readMesh(plane(list("Splits", list("upper", split))));
  EXPECT_EQ(mesh.numCells(), 56);
  EXPECT_NEAR(volume(mesh), 3.0, 1e-13);
  EXPECT_NEAR(measure(mesh, *mesh.findSide("a")), 1.1, 1e-15);
  EXPECT_NEAR(measure(mesh, *mesh.findSide("b")), 1.6, 1e-15);
  EXPECT_NEAR(measure(mesh, *mesh.findSide("c")), 0.3, 1e-15);
  EXPECT_NEAR(measure(mesh, *mesh.findSide("top")), 3.0, 1e-14);
  const std::vector<double> x = linesAlongX(mesh, 7);
  EXPECT_EQ(std::count(x.begin(), x.end(), 0.1), 1);
  EXPECT_EQ(std::count(x.begin(), x.end(), 1.7), 1);
}

TEST(Box, SplitsOfOppositeSidesMayShareAPoint)
{
  const auto split = [](const std::string& side, const std::string& names) {
    return text("Side", side) + doubles("At", "0.5") + strings("Names", names);
  };
  const Mesh mesh =
      readMesh(plane(list("Splits", list("one", split("top", "a, b")) + list("two", split("bottom", "c, d")))));
  EXPECT_NEAR(measure(mesh, *mesh.findSide("a")), 1.5, 1e-15);
  EXPECT_NEAR(measure(mesh, *mesh.findSide("c")), 1.5, 1e-15);
}

TEST(Box, SplitOnAUniformGridKeepsItUniform)
{
  const std::string split = text("Side", "top") + doubles("At", "1") + strings("Names", "contact, free top");
  const std::string box =
      text("Type", "Box") + doubles("Lower", "0, -1") + doubles("Upper", "2, 0") + ints("Cells", "60, 3");
  const Mesh whole = readMesh(box);
  const Mesh parted = readMesh(box + list("Splits", list("top", split)));
  for (int p = 0; p < whole.numPoints(); ++p)
    EXPECT_NEAR(whole.point(p)[0], parted.point(p)[0], 1e-15);
}

TEST(Box, SideInSpaceSplitsAlongEitherDirection)
{
  const auto split = [](const std::string& more) {
    return text("Side", "top") + doubles("At", "1.25") + strings("Names", "low, high") + more;
  };
  const Mesh first = readMesh(space(list("Splits", list("top", split("")))));
  EXPECT_NEAR(measure(first, *first.findSide("low")), 2.5, 1e-14);
  const Mesh second = readMesh(space(list("Splits", list("top", split(text("Direction", "Y"))))));
  EXPECT_NEAR(measure(second, *second.findSide("low")), 3.75, 1e-14);
  EXPECT_NEAR(measure(second, *second.findSide("high")), 2.25, 1e-14);
}

TEST(Box, AMillionDofsAreGenerated)
{
  const Mesh mesh =
      readMesh(text("Type", "Box") + doubles("Lower", "0, 0") + doubles("Upper", "1, 1") + ints("Cells", "354, 354"));
  EXPECT_EQ(mesh.numCells(), 2 * 354 * 354);
  EXPECT_NEAR(volume(mesh), 1.0, 1e-11);
}

TEST(BoxParts, AreGroupsOfTheCellsBetweenTheirCorners)
{
  const Mesh mesh =
      readMesh(plane(list("Parts", list("soft", doubles("Lower", "-1, 0.5") + doubles("Upper", "0.3, 1.5")) +
                                       list("low", doubles("Lower", "-1, 0.5") + doubles("Upper", "2, 0.8")))));
  EXPECT_TRUE(readMesh(plane()).groups.kind.empty());
  ASSERT_EQ(int(mesh.groups.kind.size()), mesh.numCells());
  double both = 0.0;
  for (int c = 0; c < mesh.numCells(); ++c) {
    std::vector<std::string> expected;
    const auto middle = cellCentre(mesh, c);
    if (middle[1] < 0.8)
      expected.emplace_back("low");
    if (middle[0] < 0.3)
      expected.emplace_back("soft");
    EXPECT_EQ(mesh.groups.names[std::size_t(mesh.groups.kind[std::size_t(c)])], expected);
    both += expected.size() == 2 ? cellMeasure(mesh, c) : 0.0;
  }
  EXPECT_NEAR(both, 1.3 * 0.3, 1e-14); // grid lines lie on the corners
}

} // namespace

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ndframe/mesh/mesh.hpp"

namespace
{

using namespace ndframe;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// The unit square as two triangles, with its bottom as a side.
Mesh square()
{
  Mesh mesh;
  mesh.dim = 2;
  mesh.points = {0, 0, 1, 0, 1, 1, 0, 1};
  mesh.cells = {0, 1, 2, 0, 2, 3};
  mesh.sides = {{"bottom", {{0, 2}}}};
  return mesh;
}

TEST(CheckMesh, AcceptsASoundMesh)
{
  EXPECT_THAT(checkMesh(square()), IsEmpty());
}

TEST(CheckMesh, RefusesAnEmptyMesh)
{
  Mesh mesh;
  mesh.dim = 2;
  EXPECT_THAT(checkMesh(mesh), ElementsAre("the mesh has no cells."));
}

TEST(CheckMesh, RefusesOtherDimensions)
{
  EXPECT_THAT(checkMesh(Mesh{}), ElementsAre("the mesh has dimension 0; 2 and 3 are possible."));
}

TEST(CheckMesh, RefusesVerticesOutOfRange)
{
  Mesh mesh = square();
  mesh.cells[4] = 7;
  EXPECT_THAT(checkMesh(mesh), ElementsAre("cell 1 names the vertex 7, but the mesh has only 4 points."));
}

TEST(CheckMesh, RefusesCellsThatAreTooSmallForTheirDistanceFromTheOrigin)
{
  const auto movedBy = [](double distance) {
    Mesh mesh = square();
    for (double& x : mesh.points)
      x += distance;
    return checkMesh(mesh);
  };
  EXPECT_THAT(movedBy(1e9), IsEmpty());
  EXPECT_THAT(movedBy(1e10), ElementsAre(HasSubstr("2 of 2 cells are too small so far from the origin")));
  EXPECT_THAT(movedBy(1e15), ElementsAre(HasSubstr("move the mesh towards the origin")));
}

TEST(CheckMesh, RefusesCoordinatesThatAreNotFinite)
{
  Mesh mesh = square();
  mesh.points[5] = std::nan("");
  EXPECT_THAT(checkMesh(mesh), ElementsAre("point 2 has a coordinate that is not finite."));
}

TEST(CheckMesh, CountsInvertedCells)
{
  Mesh mesh = square();
  std::swap(mesh.cells[3], mesh.cells[4]);
  EXPECT_THAT(checkMesh(mesh), ElementsAre("1 of 2 cells are inverted; the first is cell 1 at (0.333333, 0.666667)."));
}

TEST(CheckMesh, CountsDegenerateCellsInAnyUnit)
{
  for (const double unit : {1e-9, 1.0, 1e9}) {
    Mesh mesh = square();
    mesh.points = {0, 0, 0.5 * unit, 0.5 * unit, unit, unit, 0, unit};
    EXPECT_THAT(checkMesh(mesh), ElementsAre(HasSubstr("1 of 2 cells are degenerate (flat); the first is cell 0")));
  }
}

TEST(CheckMesh, AcceptsVeryThinCells)
{
  Mesh mesh = square();
  mesh.points = {0, 0, 1, 0, 1, 1e-9, 0, 1e-9};
  EXPECT_THAT(checkMesh(mesh), IsEmpty());
}

TEST(CheckMesh, CountsUnusedPoints)
{
  Mesh mesh = square();
  mesh.points.insert(mesh.points.end(), {2.0, 2.0});
  EXPECT_THAT(checkMesh(mesh), ElementsAre("1 points belong to no cell; the first is point 4."));
}

TEST(CheckMesh, CountsFacetsOfMoreThanTwoCells)
{
  Mesh mesh = square();
  mesh.points.insert(mesh.points.end(), {0.2, 0.9});
  mesh.cells.insert(mesh.cells.end(), {0, 2, 4});
  EXPECT_THAT(checkMesh(mesh), ElementsAre(HasSubstr("1 facets are shared by more than two cells")));
}

TEST(CheckMesh, NoticesCellsThatOverlap)
{
  Mesh mesh = square();
  mesh.points[6] = 0.9; // the second triangle folded over the first
  mesh.points[7] = 0.1;
  mesh.cells = {0, 1, 2, 0, 3, 2};
  EXPECT_THAT(checkMesh(mesh), ElementsAre(HasSubstr("1 facets have both their cells on the same side")));
}

TEST(CheckMesh, NoticesACellListedTwice)
{
  Mesh mesh = square();
  mesh.sides.clear();
  mesh.points.resize(6);
  mesh.cells = {0, 1, 2, 1, 2, 0};
  EXPECT_THAT(checkMesh(mesh), ElementsAre(HasSubstr("listed twice")));
}

TEST(CheckMesh, AcceptsTwoBodiesThatDoNotTouch)
{
  Mesh mesh = square();
  mesh.points.insert(mesh.points.end(), {5, 0, 6, 0, 5, 1});
  mesh.cells.insert(mesh.cells.end(), {4, 5, 6});
  EXPECT_THAT(checkMesh(mesh), IsEmpty());
}

TEST(CheckMesh, RefusesSideFacetsInside)
{
  Mesh mesh = square();
  mesh.sides[0].facets.push_back({0, 1});
  EXPECT_THAT(checkMesh(mesh), ElementsAre(AllOf(HasSubstr("1 facets of side \"bottom\" are not on the boundary"),
                                                 HasSubstr("cell 0 at (0.666667, 0.333333)"))));
}

TEST(CheckMesh, RefusesSideFacetsThatDoNotExist)
{
  Mesh mesh = square();
  mesh.sides[0].facets.push_back({2, 0});
  EXPECT_THAT(checkMesh(mesh), ElementsAre("side \"bottom\" names facet 0 of cell 2, which does not exist."));
}

TEST(CheckMesh, RefusesRepeatedFacetsAndNames)
{
  Mesh mesh = square();
  mesh.sides[0].facets.push_back({0, 2});
  mesh.sides.push_back({"bottom", {}});
  EXPECT_THAT(checkMesh(mesh), ElementsAre("side \"bottom\" lists a facet twice.", "two sides are called \"bottom\"."));
}

} // namespace

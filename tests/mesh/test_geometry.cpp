#include <cmath>

#include <gtest/gtest.h>

#include "ndframe/mesh/mesh.hpp"

namespace
{

using namespace ndframe;

Mesh triangle()
{
  Mesh mesh;
  mesh.dim = 2;
  mesh.points = {0, 0, 3, 0, 0, 4};
  mesh.cells = {0, 1, 2};
  return mesh;
}

Mesh tetrahedron()
{
  Mesh mesh;
  mesh.dim = 3;
  mesh.points = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  mesh.cells = {0, 1, 2, 3};
  return mesh;
}

TEST(Geometry, CellMeasureIsSigned)
{
  Mesh flat = triangle();
  EXPECT_DOUBLE_EQ(cellMeasure(flat, 0), 6.0);
  flat.cells = {1, 0, 2};
  EXPECT_DOUBLE_EQ(cellMeasure(flat, 0), -6.0);
  EXPECT_DOUBLE_EQ(cellMeasure(tetrahedron(), 0), 1.0 / 6);
}

TEST(Geometry, FacetIsOppositeToItsVertex)
{
  int v[3];
  facetVertices(triangle(), {0, 1}, v);
  EXPECT_EQ(v[0], 0);
  EXPECT_EQ(v[1], 2);
  facetVertices(tetrahedron(), {0, 0}, v);
  EXPECT_EQ(v[0], 1);
  EXPECT_EQ(v[1], 2);
  EXPECT_EQ(v[2], 3);
}

TEST(Geometry, FacetNormalPointsOutOfTheCellWhateverItsOrientation)
{
  Mesh mesh = triangle();
  double n[3];
  EXPECT_DOUBLE_EQ(facetNormal(mesh, {0, 0}, n), 5.0);
  EXPECT_DOUBLE_EQ(n[0], 0.8);
  EXPECT_DOUBLE_EQ(n[1], 0.6);
  mesh.cells = {0, 2, 1};
  EXPECT_DOUBLE_EQ(facetNormal(mesh, {0, 0}, n), 5.0);
  EXPECT_DOUBLE_EQ(n[0], 0.8);
  EXPECT_DOUBLE_EQ(n[1], 0.6);

  const Mesh solid = tetrahedron();
  EXPECT_DOUBLE_EQ(facetNormal(solid, {0, 0}, n), std::sqrt(3.0) / 2);
  EXPECT_DOUBLE_EQ(n[0], 1 / std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(facetNormal(solid, {0, 3}, n), 0.5);
  EXPECT_DOUBLE_EQ(n[2], -1.0);
}

TEST(Geometry, DiameterIsTheDiagonalOfTheBoundingBox)
{
  EXPECT_DOUBLE_EQ(diameter(triangle()), 5.0);
}

TEST(Geometry, FindSideAnswersNullForAnUnknownName)
{
  Mesh mesh = triangle();
  mesh.sides = {{"left", {{0, 1}}}};
  ASSERT_NE(mesh.findSide("left"), nullptr);
  EXPECT_EQ(mesh.findSide("left")->facets[0].local, 1);
  EXPECT_EQ(mesh.findSide("right"), nullptr);
}

} // namespace

#include <gtest/gtest.h>

#include "mesh/solid_scenes.hpp"
#include "ndframe/cutting/cannot_cut.hpp"
#include "ndframe/cutting/split_facets.hpp"

namespace ndframe
{
namespace
{

double volumeOf(const Mesh& mesh)
{
  double volume = 0.0;
  for (int c = 0; c < mesh.numCells(); ++c)
    volume += cellMeasure(mesh, c);
  return volume;
}

/// One tetrahedron with a side on every facet.
Mesh corner()
{
  Mesh mesh{3, {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 1, 2, 3}, {}, {}};
  for (int local = 0; local < 4; ++local)
    mesh.sides.push_back({"facet " + std::to_string(local), {{0, local}}});
  return mesh;
}

void expectSound(const DerivedMesh& cut, double volume)
{
  EXPECT_TRUE(checkMesh(cut.mesh).empty());
  EXPECT_NEAR(volumeOf(cut.mesh), volume, 1e-14);
  EXPECT_EQ(int(cut.parents.size()), cut.mesh.numCells());
}

TEST(SplitFacets, APointInAFacetMakesPyramidsOverItsTriangles)
{
  FacetSplits splits;
  splits.points = {0.25, 0.25, 0.0};
  splits.facets[{0, 3}] = {{0, 1, 4}, {1, 2, 4}, {2, 0, 4}};
  const DerivedMesh cut = splitFacets(corner(), splits);
  expectSound(cut, 1.0 / 6.0);
  EXPECT_EQ(cut.mesh.numCells(), 3);
  EXPECT_EQ(cut.mesh.numPoints(), 5);
  EXPECT_EQ(cut.mesh.findSide("facet 3")->facets.size(), 3u);
  EXPECT_EQ(cut.mesh.findSide("facet 0")->facets.size(), 1u);
}

TEST(SplitFacets, EdgesOnSeveralFacetsNeedTheCellsCentre)
{
  FacetSplits splits;
  splits.points = {0.5, 0.0, 0.0, 0.0, 0.0, 0.5}; // on edges of which no facet has all
  splits.edges[{0, 1}] = {4};
  splits.edges[{0, 3}] = {5};
  splits.edges[{1, 2}] = {6};
  splits.points.insert(splits.points.end(), {0.5, 0.5, 0.0});
  const DerivedMesh cut = splitFacets(corner(), splits);
  expectSound(cut, 1.0 / 6.0);
  EXPECT_EQ(cut.mesh.numPoints(), 8);
}

TEST(SplitFacets, NeighboursDivideCommonFacetsAlike)
{
  Mesh mesh = corner();
  mesh.points.insert(mesh.points.end(), {0.0, -1.0, 0.0});
  mesh.cells.insert(mesh.cells.end(), {0, 1, 3, 4});
  mesh.sides.clear();
  FacetSplits splits;
  splits.points = {0.4, 0.0, 0.0, 0.7, 0.0, 0.0, 0.0, 0.0, 0.3};
  splits.edges[{0, 1}] = {5, 6};
  splits.edges[{0, 3}] = {7};
  expectSound(splitFacets(mesh, splits), 1.0 / 3.0);
}

TEST(SplitFacets, RefusesCellsThatTurnOver)
{
  Mesh mesh = corner();
  FacetSplits splits;
  splits.moved[3] = {0.0, 0.0, -0.1};
  EXPECT_THROW(splitFacets(mesh, splits), CannotCut);
}

} // namespace
} // namespace ndframe

#include <cmath>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "ndframe/mesh/boundary.hpp"
#include "ndframe/mesh/cut_facets.hpp"

using namespace ndframe;

namespace
{

/// Two triangles; the first cell has the sides bottom and right, the second one top and left.
Mesh square()
{
  Mesh mesh;
  mesh.dim = 2;
  mesh.points = {0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0};
  mesh.cells = {0, 1, 2, 0, 2, 3};
  mesh.sides = {{"bottom", {{0, 2}}}, {"right", {{0, 0}}}, {"round", {{1, 0}, {1, 1}}}};
  return mesh;
}

double area(const Mesh& mesh)
{
  double sum = 0.0;
  for (int c = 0; c < mesh.numCells(); ++c)
    sum += cellMeasure(mesh, c);
  return sum;
}

double length(const Mesh& mesh, const Side& side)
{
  double sum = 0.0, normal[2];
  for (const Facet facet : side.facets)
    sum += facetNormal(mesh, facet, normal);
  return sum;
}

} // namespace

TEST(CutFacets, LeaveTheBodyAndItsSidesWhatTheyAre)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0.01, 0.99);
  for (int trial = 0; trial < 50; ++trial) {
    FacetCuts cuts;
    for (const auto& facet : {std::pair(0, 2), std::pair(0, 0), std::pair(1, 0), std::pair(1, 1)}) {
      std::vector<double> places;
      for (int k = int(random() % 4); k > 0; --k)
        places.push_back(place(random));
      std::sort(places.begin(), places.end());
      if (!places.empty())
        cuts[facet] = places;
    }
    const Mesh before = square();
    const DerivedMesh after = cutFacets(before, cuts);
    EXPECT_TRUE(checkMesh(after.mesh).empty()) << checkMesh(after.mesh).front();
    EXPECT_NEAR(area(after.mesh), 1.0, 1e-14);
    ASSERT_EQ(after.parents.size(), std::size_t(after.mesh.numCells()));
    std::map<int, double> parts;
    for (int c = 0; c < after.mesh.numCells(); ++c)
      parts[after.parents[std::size_t(c)]] += cellMeasure(after.mesh, c);
    EXPECT_NEAR(parts.at(0), 0.5, 1e-14);
    std::size_t added = 0;
    for (const auto& [facet, places] : cuts)
      added += places.size();
    EXPECT_EQ(after.mesh.numPoints(), before.numPoints() + int(added));
    EXPECT_EQ(after.mesh.numCells(), before.numCells() + int(added));
    for (std::size_t s = 0; s < before.sides.size(); ++s)
      EXPECT_NEAR(length(after.mesh, after.mesh.sides[s]), length(before, before.sides[s]), 1e-14);
    EXPECT_EQ(boundaryFacets(after.mesh).size(), 4 + added);
  }
}

TEST(CutFacets, StandWhereTheyWereAskedFor)
{
  const DerivedMesh cut = cutFacets(square(), {{{0, 2}, {0.25, 0.5}}});
  const Side& bottom = *cut.mesh.findSide("bottom");
  ASSERT_EQ(bottom.facets.size(), 3u);
  EXPECT_NEAR(facetCentre(cut.mesh, bottom.facets[0])[0], 0.125, 1e-15);
  EXPECT_NEAR(facetCentre(cut.mesh, bottom.facets[1])[0], 0.375, 1e-15);
  EXPECT_NEAR(facetCentre(cut.mesh, bottom.facets[2])[0], 0.75, 1e-15);
  for (const Facet facet : bottom.facets) {
    double normal[2];
    facetNormal(cut.mesh, facet, normal);
    EXPECT_EQ(normal[1], -1.0);
  }
}

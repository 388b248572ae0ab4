#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "mesh/solid_scenes.hpp"
#include "meshing/mesh_deck.hpp"
#include "ndframe/cutting/common_facets.hpp"
#include "ndframe/cutting/solid_sides.hpp"

namespace ndframe
{
namespace
{

using test::boundaryArea;

Mesh box(const char* lower, const char* upper, const char* cells)
{
  return test::readMesh(test::text("Type", "Box") + test::doubles("Lower", lower) + test::doubles("Upper", upper) +
                        test::ints("Cells", cells));
}

double volumeOf(const Mesh& mesh)
{
  double volume = 0.0;
  for (int c = 0; c < mesh.numCells(); ++c)
    volume += cellMeasure(mesh, c);
  return volume;
}

double areaOf(const Mesh& mesh, const std::vector<Facet>& facets)
{
  double area = 0.0, normal[3];
  for (const Facet facet : facets)
    area += facetNormal(mesh, facet, normal);
  return area;
}

/// Turns by an angle about an axis and moves, so that nothing is parallel to an axis.
void turn(Mesh& mesh, double about, double along)
{
  for (int p = 0; p < mesh.numPoints(); ++p) {
    double* x = mesh.points.data() + 3 * p;
    const double c = std::cos(about), s = std::sin(about), d = std::cos(along), e = std::sin(along);
    const double u = c * x[0] - s * x[1], v = s * x[0] + c * x[1];
    x[0] = d * u - e * x[2];
    x[1] = v;
    x[2] = e * u + d * x[2];
  }
}

struct Pair
{
  std::vector<Mesh> meshes; ///< the upper one first
  double common;            ///< area of what lies on each other
};

std::vector<SolidSides> sides()
{
  return {{0, 1, "bottom", "top", true}};
}

std::vector<Pair> scenes()
{
  std::vector<Pair> all;
  all.push_back({{box("0, 0, 0", "1, 1, 1", "2, 2, 1"), box("0, 0, -1", "2, 2, 0", "3, 5, 1")}, 1.0});
  all.push_back({{box("0, 0, 0", "1, 1, 1", "1, 1, 1"), box("-1, -1, -1", "2, 2, 0", "9, 8, 1")}, 1.0});
  all.push_back({{box("0.5, 0.5, 0", "2, 2, 1", "4, 3, 1"), box("0, 0, -1", "1, 1, 0", "3, 2, 1")}, 0.25});
  all.push_back({{box("-0.5, -0.5, 0", "0.5, 0.5, 1", "3, 3, 2"), box("-1, -1, -1", "1, 1, 0", "4, 4, 1")}, 1.0});
  turn(all.back().meshes[0], 0.4, 0.0); // one on the other
  for (std::size_t k = 0; k < 4; ++k) { // together
    all.push_back(all[k]);
    for (Mesh& mesh : all.back().meshes)
      turn(mesh, 0.7, 0.3);
  }
  return all;
}

TEST(CutSolids, SidesGetCommonFacetsWhereverTheyLieOnEachOther)
{
  for (const Pair& pair : scenes()) {
    const auto cut = cutSolids(pair.meshes, sides());
    for (std::size_t b = 0; b < 2; ++b) {
      EXPECT_TRUE(checkMesh(cut[b].mesh).empty());
      EXPECT_NEAR(volumeOf(cut[b].mesh), volumeOf(pair.meshes[b]), 1e-12);
      EXPECT_NEAR(boundaryArea(cut[b].mesh), boundaryArea(pair.meshes[b]), 1e-11);
      for (const Side& side : pair.meshes[b].sides)
        EXPECT_NEAR(areaOf(cut[b].mesh, cut[b].mesh.findSide(side.name)->facets), areaOf(pair.meshes[b], side.facets),
                    1e-12);
    }
    const auto common =
        commonFacets(cut[0].mesh, *cut[0].mesh.findSide("bottom"), cut[1].mesh, *cut[1].mesh.findSide("top"));
    EXPECT_NEAR(areaOf(cut[0].mesh, common.firstFacets), pair.common, 1e-12);
    EXPECT_NEAR(areaOf(cut[1].mesh, common.secondFacets), pair.common, 1e-12);
  }
}

TEST(CutSolids, TheSecondTimeNothingIsLeftToBeCut)
{
  for (const Pair& pair : scenes()) {
    const auto cut = cutSolids(pair.meshes, sides());
    const auto again = cutSolids({cut[0].mesh, cut[1].mesh}, sides());
    for (std::size_t b = 0; b < 2; ++b)
      EXPECT_EQ(again[b].mesh.numCells(), cut[b].mesh.numCells());
  }
}

TEST(CutSolids, EveryPartLiesInItsParent)
{
  for (const Pair& pair : scenes()) {
    const auto cut = cutSolids(pair.meshes, sides());
    for (std::size_t b = 0; b < 2; ++b) {
      if (cut[b].parents.empty())
        continue;
      std::vector<double> volumes(std::size_t(pair.meshes[b].numCells()), 0.0);
      for (int c = 0; c < cut[b].mesh.numCells(); ++c)
        volumes[std::size_t(cut[b].parents[std::size_t(c)])] += cellMeasure(cut[b].mesh, c);
      double moved = 0.0; // by vertices that move within the side
      for (int c = 0; c < pair.meshes[b].numCells(); ++c)
        moved += std::abs(volumes[std::size_t(c)] - cellMeasure(pair.meshes[b], c));
      EXPECT_LT(moved, 0.4 * volumeOf(pair.meshes[b]));
    }
  }
}

TEST(CutSolids, SidesThatMatchStayAsTheyAre)
{
  const std::vector<Mesh> meshes{box("0, 0, 0", "1, 1, 1", "2, 3, 1"), box("0, 0, -1", "1, 1, 0", "2, 3, 1")};
  for (const DerivedMesh& cut : cutSolids(meshes, sides()))
    EXPECT_TRUE(cut.parents.empty());
}

TEST(CutSolids, SidesThatShareAnEdgeAgree)
{
  std::vector<Mesh> meshes{box("0, 0, 0", "1, 1, 1", "2, 2, 1"), box("1, 0, 0", "2, 1, 1", "3, 3, 1"),
                           box("0, 0, -1", "2, 1, 0", "5, 2, 1")};
  const std::vector<SolidSides> all{
      {0, 2, "bottom", "top", true}, {1, 2, "bottom", "top", true}, {0, 1, "right", "left", true}};
  const auto cut = cutSolids(meshes, all);
  for (const SolidSides& one : all) {
    const Mesh &first = cut[std::size_t(one.firstBody)].mesh, &second = cut[std::size_t(one.secondBody)].mesh;
    const auto common = commonFacets(first, *first.findSide(one.firstSide), second, *second.findSide(one.secondSide));
    EXPECT_NEAR(areaOf(first, common.firstFacets), 1.0, 1e-12);
  }
}

TEST(Rims, AreVerticesOfTheOtherSide)
{
  std::vector<Mesh> meshes{box("0.3, 0.3, 0", "1, 1, 1", "2, 2, 1"), box("-1, -1, -1", "2, 2, 0", "7, 7, 1")};
  const double volume = volumeOf(meshes[1]);
  moveToRims(meshes[0], "bottom", meshes[1], "top");
  cutAtRims(meshes[1], "top", meshes[0], "bottom");
  EXPECT_TRUE(checkMesh(meshes[1]).empty());
  EXPECT_NEAR(volumeOf(meshes[1]), volume, 1e-12);
  EXPECT_FALSE(cutAtRims(meshes[1], "top", meshes[0], "bottom")); // all of it is there
}

} // namespace
} // namespace ndframe

// Parts along a segment become as small as it says, and hardly any others.

#include <cmath>

#include <gtest/gtest.h>

#include "components.hpp"
#include "ndframe/adaptivity/size_field.hpp"

using namespace ndframe;

namespace
{

/// (0, 1) x (0, height), cut along a diagonal.
Mesh rectangle(double height)
{
  Mesh mesh;
  mesh.dim = 2;
  mesh.points = {0.0, 0.0, 1.0, 0.0, 1.0, height, 0.0, height};
  mesh.cells = {0, 1, 2, 0, 2, 3};
  return mesh;
}

/// Nothing is asked for but facets of this length along a piece of the bottom.
SizeField alongBottom(const Mesh& mesh, double from, double to, double length)
{
  CellSize size{100.0, 0.0, -100.0};
  size.fine = {{{from, 0.0}, {to, 0.0}, length}};
  return {std::vector<CellSize>(std::size_t(mesh.numCells()), size)};
}

/// The longest facet on the bottom of which more than a fiftieth lies on a piece of it.
double longestFacet(const Mesh& mesh, double from, double to)
{
  double longest = 0.0;
  for (int c = 0; c < mesh.numCells(); ++c)
    for (int local = 0; local < 3; ++local) {
      const double* one = mesh.point(mesh.cell(c)[(local + 1) % 3]);
      const double* other = mesh.point(mesh.cell(c)[(local + 2) % 3]);
      const double least = std::min(one[0], other[0]), most = std::max(one[0], other[0]);
      if (one[1] == 0.0 && other[1] == 0.0 && std::min(to, most) - std::max(from, least) > 0.02 * (most - least))
        longest = std::max(longest, most - least);
    }
  return longest;
}

} // namespace

TEST(FineSegment, FacetsOnItAreAsShortAsItSays)
{
  for (const double height : {0.1, 0.5, 1.0, 2.0})
    for (const double length : {0.3, 0.1, 0.03, 0.004})
      for (const double from : {0.0, 0.1, 1.0 / 3.0, 0.96}) {
        const Mesh mesh = rectangle(height);
        const double to = from + 0.04;
        const auto fine = test::bisected(mesh)->refined(alongBottom(mesh, from, to, length));
        EXPECT_LE(longestFacet(fine->meshes()[0], from, to), length) << height << ", " << from;
      }
}

TEST(FineSegment, CostsAFewCellsForEachHalving)
{
  const Mesh mesh = rectangle(1.0);
  int before = mesh.numCells();
  for (double length = 0.03; length > 1e-6; length *= 0.25) {
    const double to = 0.3 + length;
    const auto fine = test::bisected(mesh)->refined(alongBottom(mesh, 0.3, to, length));
    const int cells = fine->meshes()[0].numCells();
    EXPECT_LE(longestFacet(fine->meshes()[0], 0.3, to), length);
    EXPECT_LT(cells, before + 90) << length;
    before = cells;
  }
}

TEST(FineSegment, KnowsItsFacets)
{
  const Mesh mesh = rectangle(1.0);
  const auto facetOn = [&](std::array<double, 2> from, std::array<double, 2> to) {
    return FineSegment{from, to, 1.0}.facetOn(mesh, 0);
  };
  EXPECT_EQ(facetOn({0.2, 0.0}, {0.3, 0.0}), 1.0);
  EXPECT_EQ(facetOn({0.3, 0.0}, {0.2, 0.0}), 1.0);
  EXPECT_EQ(facetOn({1.0, 0.3}, {1.0, 0.9}), 1.0);
  EXPECT_EQ(facetOn({0.2, -0.1}, {0.3, -0.1}), 1.0); // a chord
  EXPECT_EQ(facetOn({0.2, 0.2}, {0.3, 0.3}), std::sqrt(2.0));
  EXPECT_EQ(facetOn({0.2, -0.3}, {0.3, -0.3}), 0.0);
  EXPECT_EQ(facetOn({1.0, 0.0}, {2.0, 0.0}), 0.0); // begins where the facet ends
  EXPECT_EQ(facetOn({-2.0, 0.0}, {0.0, 0.0}), 0.0);
}

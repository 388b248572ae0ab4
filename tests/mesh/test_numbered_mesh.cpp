// Parts of a mesh with the numbers of the whole.

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "meshing/mesh_deck.hpp"
#include "ndframe/mesh/numbered_mesh.hpp"

namespace
{

using namespace ndframe;
using namespace ndframe::test;

/// All of a mesh, whose points and cells have every third number.
NumberedMesh whole(const char* corner, const char* cells)
{
  const std::string origin = std::string(corner).size() > 4 ? "0, 0, 0" : "0, 0";
  NumberedMesh all{readMesh(text("Type", "Box") + doubles("Lower", origin) + doubles("Upper", corner) +
                            ints("Cells", cells) + text("Pattern", "Right")),
                   {},
                   {}};
  for (int point = 0; point < all.mesh.numPoints(); ++point)
    all.points.push_back(3 * point + 5);
  for (int cell = 0; cell < all.mesh.numCells(); ++cell)
    all.cells.push_back(3 * cell);
  return all;
}

std::vector<NumberedMesh> samples()
{
  return {whole("3, 1", "3, 2"), whole("2, 1, 1", "3, 2, 2")};
}

void expectEqual(const NumberedMesh& a, const NumberedMesh& b)
{
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.cells, b.cells);
  EXPECT_EQ(a.mesh.points, b.mesh.points);
  EXPECT_EQ(a.mesh.cells, b.mesh.cells);
  ASSERT_EQ(a.mesh.sides.size(), b.mesh.sides.size());
  for (std::size_t s = 0; s < a.mesh.sides.size(); ++s) {
    EXPECT_EQ(a.mesh.sides[s].name, b.mesh.sides[s].name);
    const std::vector<Facet>&ours = a.mesh.sides[s].facets, &theirs = b.mesh.sides[s].facets;
    ASSERT_EQ(ours.size(), theirs.size());
    for (std::size_t f = 0; f < ours.size(); ++f)
      EXPECT_TRUE(ours[f].cell == theirs[f].cell && ours[f].local == theirs[f].local);
  }
}

} // namespace

TEST(NumberedMeshes, ThatOverlapAreJoinedToTheWhole)
{
  for (const NumberedMesh& sample : samples()) {
    const NumberedMesh all = joined({sample}); // its facets in order
    std::vector<NumberedMesh> parts;
    for (const int first : {2, 0, 1}) // each cell is in one or two
      parts.push_back(sample.only([&](int cell) { return cell % 3 == first || cell % 5 == first; }));
    expectEqual(joined(parts), all);
    expectEqual(joined({parts[1], parts[1]}), joined({parts[1]}));
  }
}

TEST(NumberedMeshes, KeepNumbersPlacesAndSides)
{
  for (const NumberedMesh& sample : samples()) {
    const NumberedMesh part = sample.only([](int cell) { return cell % 4 == 1; });
    ASSERT_EQ(part.mesh.numPoints(), int(part.points.size()));
    ASSERT_EQ(part.mesh.numCells(), int(part.cells.size()));
    EXPECT_TRUE(std::is_sorted(part.points.begin(), part.points.end()));
    EXPECT_EQ(part.mesh.sides.size(), sample.mesh.sides.size());
    const auto pointIn = [&](std::size_t point) { return int(part.points[point] - 5) / 3; };
    for (std::size_t cell = 0; cell < part.cells.size(); ++cell)
      for (int v = 0; v <= sample.mesh.dim; ++v)
        EXPECT_EQ(pointIn(std::size_t(part.mesh.cell(int(cell))[v])), sample.mesh.cell(int(part.cells[cell] / 3))[v]);
    for (std::size_t point = 0; point < part.points.size(); ++point)
      EXPECT_TRUE(std::equal(part.mesh.point(int(point)), part.mesh.point(int(point)) + sample.mesh.dim,
                             sample.mesh.point(pointIn(point))));
  }
}

TEST(NumberedMeshes, AreTheSameAsBytes)
{
  for (const NumberedMesh& sample : samples()) {
    const NumberedMesh part = sample.only([](int cell) { return cell % 2 == 0; });
    expectEqual(numberedMeshFromBytes(toBytes(part)), part);
  }
}

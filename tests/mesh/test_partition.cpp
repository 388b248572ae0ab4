#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "meshing/mesh_deck.hpp"
#include "ndframe/mesh/partition.hpp"

namespace
{

using namespace ndframe;
using namespace ndframe::test;

Mesh grid()
{
  return readMesh(text("Type", "Box") + doubles("Lower", "0, 0") + doubles("Upper", "2, 1") + ints("Cells", "40, 20"));
}

TEST(Partition, OnePartOwnsEverything)
{
  const Mesh mesh = grid();
  EXPECT_EQ(partitionNodes(mesh.cells, 3, mesh.numPoints(), 1), std::vector<int>(mesh.numPoints(), 0));
}

TEST(Partition, CoversAllNodesInBalancedParts)
{
  const Mesh mesh = grid();
  for (const int parts : {2, 3, 7}) {
    const std::vector<int> owner = partitionNodes(mesh.cells, 3, mesh.numPoints(), parts);
    ASSERT_EQ(int(owner.size()), mesh.numPoints());
    std::vector<int> sizes(parts, 0);
    for (const int part : owner) {
      ASSERT_GE(part, 0);
      ASSERT_LT(part, parts);
      ++sizes[part];
    }
    const double average = double(mesh.numPoints()) / parts;
    EXPECT_GT(*std::min_element(sizes.begin(), sizes.end()), 0.9 * average);
    EXPECT_LT(*std::max_element(sizes.begin(), sizes.end()), 1.1 * average);
  }
}

TEST(Partition, CutsFewCells)
{
  const Mesh mesh = grid();
  const std::vector<int> owner = partitionNodes(mesh.cells, 3, mesh.numPoints(), 2);
  int cut = 0;
  for (int c = 0; c < mesh.numCells(); ++c)
    cut += owner[mesh.cell(c)[0]] != owner[mesh.cell(c)[1]] || owner[mesh.cell(c)[0]] != owner[mesh.cell(c)[2]];
  EXPECT_GT(cut, 0);
  EXPECT_LT(cut, 4 * 20 * 2); // a straight cut through the middle meets 40 triangles
}

TEST(Partition, IsDeterministic)
{
  const Mesh mesh = grid();
  EXPECT_EQ(partitionNodes(mesh.cells, 3, mesh.numPoints(), 3), partitionNodes(mesh.cells, 3, mesh.numPoints(), 3));
}

TEST(PartitionByPlace, PartsAreEqualToOneAndHangTogether)
{
  std::vector<std::array<double, 3>> points;
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 5; ++j)
      for (int k = 0; k < 4; ++k)
        points.push_back({double(i), double(j), double(k)});
  for (const int parts : {1, 2, 3, 4, 7, 8}) {
    const std::vector<int> owner = partitionByPlace(points, parts);
    std::vector<int> count(std::size_t(parts), 0);
    for (const int part : owner)
      ++count[std::size_t(part)];
    EXPECT_LE(*std::max_element(count.begin(), count.end()) - *std::min_element(count.begin(), count.end()), 1)
        << parts;
    int cut = 0; // neighbours along x of different parts
    for (std::size_t i = 0; i + 20 < points.size(); ++i)
      cut += int(owner[i] != owner[i + 20]);
    EXPECT_LE(cut, 20 * (parts - 1)) << parts;
  }
  EXPECT_EQ(partitionByPlace({}, 3), std::vector<int>());
  EXPECT_EQ(partitionByPlace({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, 3), (std::vector<int>{0, 1, 2}));
}

} // namespace

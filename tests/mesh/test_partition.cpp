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

} // namespace

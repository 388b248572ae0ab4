#include <gmock/gmock.h>

#include <algorithm>
#include <random>

#include "ndframe/coupling/odd_cycle.hpp"

namespace ndframe
{
namespace
{

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;
using testing::UnorderedElementsAre;
using Edges = std::vector<std::pair<int, int>>;

bool areNeighbours(const Edges& edges, int a, int b)
{
  return std::any_of(edges.begin(), edges.end(),
                     [&](const auto& edge) { return edge == std::pair(a, b) || edge == std::pair(b, a); });
}

/// Tried with every colouring.
bool hasTwoColours(int numNodes, const Edges& edges)
{
  for (int colours = 0; colours < 1 << numNodes; ++colours)
    if (std::all_of(edges.begin(), edges.end(),
                    [&](const auto& edge) { return ((colours >> edge.first) & 1) != ((colours >> edge.second) & 1); }))
      return true;
  return false;
}

TEST(OddCycle, ChainsAndEvenRingsHaveNone)
{
  EXPECT_THAT(oddCycle(0, {}), IsEmpty());
  EXPECT_THAT(oddCycle(4, {{0, 1}, {1, 2}, {2, 3}}), IsEmpty());
  EXPECT_THAT(oddCycle(4, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}), IsEmpty());
  EXPECT_THAT(oddCycle(2, {{0, 1}, {0, 1}}), IsEmpty());
}

TEST(OddCycle, OfATriangleBehindAChain)
{
  EXPECT_THAT(oddCycle(5, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 2}}), UnorderedElementsAre(2, 3, 4));
  EXPECT_THAT(oddCycle(1, {{0, 0}}), ElementsAre(0));
}

TEST(OddCycle, IsFoundWhereNoTwoColoursAreAndCanBeWalked)
{
  std::mt19937 random(1);
  for (int scene = 0; scene < 300; ++scene) {
    const int n = 3 + int(random() % 6);
    Edges edges;
    for (int a = 0; a < n; ++a)
      for (int b = a + 1; b < n; ++b)
        if (random() % 3 == 0)
          edges.emplace_back(a, b);
    std::shuffle(edges.begin(), edges.end(), random);
    const std::vector<int> cycle = oddCycle(n, edges);
    ASSERT_EQ(cycle.empty(), hasTwoColours(n, edges));
    if (cycle.empty())
      continue;
    EXPECT_EQ(cycle.size() % 2, 1u);
    for (std::size_t i = 0; i < cycle.size(); ++i)
      EXPECT_TRUE(areNeighbours(edges, cycle[i], cycle[(i + 1) % cycle.size()]));
    std::vector<int> nodes = cycle;
    std::sort(nodes.begin(), nodes.end());
    EXPECT_EQ(std::unique(nodes.begin(), nodes.end()), nodes.end());
  }
}

} // namespace
} // namespace ndframe

// What a rank has of a body that no rank has as a whole.

#include <algorithm>

#include <gtest/gtest.h>

#include "common/test_main.hpp"
#include "ndframe/assembly/body_share.hpp"
#include "ndframe/assembly/share_boundary.hpp"

namespace
{

using namespace ndframe;
using Global = BodyShare::Global;

constexpr int each = 4;                 ///< own nodes of a rank
constexpr Global first = 5'000'000'000; ///< number of the first of all

/// A chain of nodes, `each` to a rank, which has the last one before and the first one after its own, too.
class Chain
{
public:
  Chain() : share_({first + each * ranks(), numbers(), owners()}, {7, {4, 5, 6, 1}, cellOwners()}, test::comm()) {}
  const BodyShare& operator*() const { return share_; }

  static int ranks() { return test::comm().size(); }
  static int rank() { return test::comm().rank(); }
  static int before() { return rank() > 0 ? 1 : 0; } ///< nodes of other ranks before the own ones
  static std::vector<Global> numbers()
  {
    std::vector<Global> all;
    for (int node = each * rank() - 1; node <= each * (rank() + 1); ++node)
      if (node >= 0 && node < each * ranks())
        all.push_back(first + node);
    return all;
  }

private:
  static std::vector<int> owners()
  {
    std::vector<int> all;
    for (const Global number : numbers())
      all.push_back(int(number - first) / each);
    return all;
  }

  static std::vector<int> cellOwners() { return {rank(), rank(), rank(), rank() + 1}; }

  BodyShare share_;
};

TEST(BodyShare, KnowsWhatIsItsOwn)
{
  const Chain chain;
  const std::vector<int> own = (*chain).ownNodes();
  ASSERT_EQ(own.size(), std::size_t(each));
  for (const int node : own) {
    EXPECT_TRUE((*chain).owns(node));
    EXPECT_EQ((*chain).numbers()[std::size_t(node)], first + each * Chain::rank() + node - Chain::before());
  }
  EXPECT_EQ((*chain).numNodes(), first + each * Chain::ranks());
  EXPECT_EQ((*chain).numCells(), 7);
  EXPECT_EQ((*chain).numOwnCells(), 3);
}

TEST(BodyShare, GetsTheValuesOfOtherOwners)
{
  const Chain chain;
  Vector own;
  for (int i = 0; i < each; ++i) // two values a node, of all ranks different ones
    own.insert(own.end(), {double(each * Chain::rank() + i), -0.5 * i});
  const Vector all = (*chain).spread(own, 2);
  const std::vector<Global> numbers = Chain::numbers();
  ASSERT_EQ(all.size(), 2 * numbers.size());
  for (std::size_t node = 0; node < numbers.size(); ++node) {
    EXPECT_EQ(all[2 * node], double(numbers[node] - first));
    EXPECT_EQ(all[2 * node + 1], -0.5 * double((numbers[node] - first) % each));
  }
  EXPECT_EQ((*chain).own(all, 2), own);
}

TEST(BodyShare, ForgetsTheValuesOfOtherOwners)
{
  const Chain chain;
  Vector values(Chain::numbers().size(), 1.0);
  (*chain).annulOthers(values, 1);
  for (std::size_t node = 0; node < values.size(); ++node)
    EXPECT_EQ(values[node], (*chain).owns(int(node)) ? 1.0 : 0.0);
}

/// A strip of squares of two triangles each, one square to a rank; the nodes between two are the next rank's.
TEST(BodyShare, ItsBoundaryIsThatOfTheWhole)
{
  const int rank = Chain::rank(), last = Chain::ranks() - 1;
  Mesh mesh;
  mesh.dim = 2;
  std::vector<Global> numbers;
  std::vector<int> owners;
  for (int node = 2 * rank; node < 2 * rank + 4; ++node) {
    numbers.push_back(node);
    owners.push_back(std::min(node / 2, last));
    mesh.points.insert(mesh.points.end(), {double(node / 2), double(node % 2)});
  }
  mesh.cells = {0, 2, 3, 0, 3, 1};
  const BodyShare share({2 * (last + 2), numbers, owners}, {2 * (last + 1), {2 * rank, 2 * rank + 1}, {rank, rank}},
                        test::comm());
  Vector ranks(numbers.size(), double(rank));
  share.fetch(ranks, 1);
  EXPECT_EQ(std::vector<int>(ranks.begin(), ranks.end()), owners);
  std::vector<std::pair<int, int>> edges;
  for (const Facet facet : ownBoundary(mesh, share, test::comm())) {
    int vertices[3];
    facetVertices(mesh, facet, vertices);
    edges.emplace_back(std::min(vertices[0], vertices[1]), std::max(vertices[0], vertices[1]));
  }
  std::sort(edges.begin(), edges.end());
  std::vector<std::pair<int, int>> expected{{0, 2}, {1, 3}};
  if (rank == 0)
    expected.insert(expected.begin(), {0, 1});
  if (rank == last)
    expected.emplace_back(2, 3);
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(edges, expected);
}

} // namespace

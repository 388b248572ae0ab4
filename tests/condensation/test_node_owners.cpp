#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "driver/scene.hpp"
#include "ndframe/scene/model.hpp"
#include "node_owners.hpp"

namespace ndframe::test
{
namespace
{

Model modelOf(const std::string& deck)
{
  return buildModel(readScene(Scene(deck).params()), components());
}

/// Per body and node its owner; fails where a node has none or several.
std::vector<std::vector<int>> ownersOf(const Model& model, int ranks)
{
  const NodeOwners owners(model, ranks);
  std::vector<std::vector<int>> result;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    result.emplace_back(std::size_t(model.bodies[b].nodes.numNodes()), -1);
    for (int rank = 0; rank < ranks; ++rank)
      for (const int node : owners.ownedBy(rank, int(b))) {
        EXPECT_EQ(result[b][std::size_t(node)], -1);
        result[b][std::size_t(node)] = rank;
      }
    EXPECT_EQ(std::count(result[b].begin(), result[b].end(), -1), 0);
  }
  return result;
}

std::vector<int> sizes(const std::vector<std::vector<int>>& owners, std::size_t first, std::size_t last, int ranks)
{
  std::vector<int> result(std::size_t(ranks), 0);
  for (std::size_t b = first; b < last; ++b)
    for (const int rank : owners[b])
      ++result[std::size_t(rank)];
  return result;
}

} // namespace

TEST(NodeOwners, GiveBothPartnersOfAContactPairToOneRankWhereBodiesAreSolvedTogether)
{
  for (const char* deck : {"punch-3d", "punch"}) {
    Model model = modelOf(deck);
    model.solvesWhole = true;
    for (const int ranks : {2, 3, 8}) {
      const auto owners = ownersOf(model, ranks);
      for (const InterfaceMesh& interface : model.interfaces)
        for (int i = 0; i < interface.numNodes(); ++i) {
          const auto& [one, other] = interface.sides;
          EXPECT_EQ(owners[std::size_t(one.body)][std::size_t(one.nodes[std::size_t(i)])],
                    owners[std::size_t(other.body)][std::size_t(other.nodes[std::size_t(i)])]);
        }
    }
  }
}

TEST(NodeOwners, AreBalancedOverAllBodiesThatAreSolvedTogether)
{
  Model model = modelOf("punch-3d");
  model.solvesWhole = true;
  const auto owners = ownersOf(model, 4);
  const std::vector<int> parts = sizes(owners, 0, 2, 4);
  const int all = std::accumulate(parts.begin(), parts.end(), 0);
  for (const int part : parts)
    EXPECT_NEAR(part, 0.25 * all, 0.025 * all);
}

/// Bodies that are solved one after the other would wait for each other.
TEST(NodeOwners, AreBalancedInEachBodyElse)
{
  Model model = modelOf("punch-3d");
  model.solvesWhole = false;
  const auto owners = ownersOf(model, 4);
  for (std::size_t b = 0; b < owners.size(); ++b)
    for (const int part : sizes(owners, b, b + 1, 4))
      EXPECT_NEAR(part, 0.25 * double(owners[b].size()), 0.05 * double(owners[b].size()));
}

TEST(NodeOwners, AreAllRankZeroOnOneRank)
{
  const Model model = modelOf("punch");
  for (const auto& body : ownersOf(model, 1))
    EXPECT_EQ(std::count(body.begin(), body.end(), 0), std::ptrdiff_t(body.size()));
}

} // namespace ndframe::test

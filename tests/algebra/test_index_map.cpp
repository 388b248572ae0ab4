#include <gtest/gtest.h>

#include "algebra/sample_bodies.hpp"
#include "common/test_main.hpp"
#include "ndframe/algebra/index_map.hpp"

namespace ndframe
{

using Globals = std::vector<IndexMap::Global>;

TEST(IndexMap, GivesOwnNumbersFirstThenGhostsBothAscending)
{
  const IndexMap map(12, {2, 5, 9}, {11, 5, 0, 11, 3, 2});
  EXPECT_EQ(map.globalSize(), 12);
  EXPECT_EQ(map.numOwned(), 3);
  EXPECT_FALSE(map.isWhole());
  Globals numbers;
  for (int i = 0; i < map.size(); ++i)
    numbers.push_back(map.global(i));
  EXPECT_EQ(numbers, (Globals{2, 5, 9, 0, 3, 11}));
  EXPECT_TRUE(map.owns(2));
  EXPECT_FALSE(map.owns(3));
  EXPECT_FALSE(map.owns(map.local(3))); // which it does not hold
}

TEST(IndexMap, LocalAndGlobalNumbersAreInverse)
{
  const IndexMap map(40, {1, 7, 8, 30}, {39, 2, 29, 31});
  for (int i = 0; i < map.size(); ++i)
    EXPECT_EQ(map.local(map.global(i)), i);
  int held = 0;
  for (IndexMap::Global number = -1; number <= 40; ++number)
    held += map.local(number) >= 0 ? 1 : 0;
  EXPECT_EQ(held, map.size());
}

TEST(IndexMap, HoldingEverythingStoresNothingAndIsTheIdentity)
{
  const IndexMap whole = IndexMap::whole(5), same(5, {0, 1, 2, 3, 4}, {3});
  for (const IndexMap& map : {whole, same}) {
    EXPECT_TRUE(map.isWhole());
    EXPECT_EQ(map.size(), 5);
    for (int i = 0; i < 5; ++i)
      EXPECT_EQ(map.local(map.global(i)), i);
    EXPECT_EQ(map.local(5), -1);
    EXPECT_EQ(map.local(-1), -1);
  }
}

TEST(IndexMap, ARankMayOwnNothing)
{
  const IndexMap map(3, {}, {2});
  EXPECT_EQ(map.numOwned(), 0);
  EXPECT_EQ(map.size(), 1);
  EXPECT_EQ(map.global(0), 2);
  EXPECT_TRUE(IndexMap().isWhole());
}

// A scene beyond 2^31 numbers, of which a rank holds a few.
TEST(IndexMap, GlobalNumbersHave64Bits)
{
  constexpr IndexMap::Global many = IndexMap::Global(1) << 35;
  const IndexMap map(many, {many / 2, many - 1}, {7});
  EXPECT_EQ(map.local(many - 1), 1);
  EXPECT_EQ(map.global(2), 7);
  const IndexMap both = stacked({&map, &map});
  EXPECT_EQ(both.globalSize(), 2 * many);
  EXPECT_EQ(both.global(3), 2 * many - 1);
  EXPECT_EQ(both.local(many + 7), 5);
}

TEST(IndexMap, ARankHoldsAtMostWhat32BitsNumber)
{
  EXPECT_THROW(IndexMap::whole(IndexMap::Global(1) << 31), std::length_error);
}

TEST(IndexMap, StackedOwnNumbersComeBeforeAllGhosts)
{
  const IndexMap first(4, {1, 2}, {3}), second = IndexMap::whole(2), third(3, {0}, {2, 1});
  const IndexMap all = stacked({&first, &second, &third});
  Globals numbers;
  for (int i = 0; i < all.size(); ++i)
    numbers.push_back(all.global(i));
  EXPECT_EQ(numbers, (Globals{1, 2, 4, 5, 6, 3, 7, 8}));
  EXPECT_EQ(all.numOwned(), 5);
}

// Products of forged rows: the numbers of nodes reach beyond 2^31, those of columns do not.
TEST(BlockMatrix, FarNodesHaveNearColumns)
{
  constexpr IndexMap::Global far = IndexMap::Global(3) << 31;
  const BlockMatrix K{1, IndexMap(far, {far - 2, far - 1}, {5}), {0, 2, 4}, {0, 2, 0, 1}, {1.0, 2.0, 3.0, 4.0}};
  EXPECT_EQ(K.nodes.global(K.cols[1]), 5);
  EXPECT_EQ(*K.block(1, K.nodes.local(far - 1)), 4.0);
  EXPECT_EQ(K.block(1, K.nodes.local(5)), nullptr);
  EXPECT_THROW(K.numNodes(), InternalError);
}

TEST(BlockMatrix, OwnColumnsAscendInEveryRow)
{
  const test::SampleBody body = test::trussBody({5, 4, 3}, test::comm()),
                         whole = test::trussBody({5, 4, 3}, Comm::single());
  const BlockMatrix &K = body.matrix, &all = whole.matrix;
  for (int r = 0; r < K.numRows(); ++r) {
    const auto first = K.rowPtr[std::size_t(r)], last = K.rowPtr[std::size_t(r) + 1];
    EXPECT_TRUE(std::is_sorted(K.cols.begin() + first, K.cols.begin() + last));
    EXPECT_EQ(K.rowOf(K.rowNode(r)), r);
    for (std::int64_t b = first; b < last; ++b)
      EXPECT_TRUE(
          std::equal(K.values.begin() + b * 9, K.values.begin() + (b + 1) * 9, all.block(K.rowNode(r), K.colNode(b))));
  }
}

} // namespace ndframe

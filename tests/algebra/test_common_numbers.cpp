// Numbers of what several ranks have, each a part.

#include <gtest/gtest.h>

#include <algorithm>

#include "common/test_main.hpp"
#include "ndframe/algebra/common_numbers.hpp"

namespace ndframe
{
namespace
{

constexpr std::int64_t bound = 6'000'000'000, numKeys = 95;

/// Some different keys, in no order.
CommonKey key(std::int64_t i)
{
  return {i * 7919 % 101 * (bound / 101), i % 5, -1, i * i % 7};
}

/// Whether a rank has a key: some have none, some all of them.
bool has(int rank, std::int64_t i)
{
  return (i + rank) % 3 != 0 || i % 10 == rank;
}

} // namespace

TEST(CommonNumbers, AreThoseOfAllKeysInOrder)
{
  const Comm& comm = test::comm();
  std::vector<CommonKey> own, all;
  std::vector<std::int64_t> things;
  for (std::int64_t i = 0; i < numKeys; ++i) {
    bool isThere = false;
    for (int rank = 0; rank < comm.size(); ++rank)
      isThere = isThere || has(rank, i);
    if (isThere)
      all.push_back(key(i));
    if (has(comm.rank(), i)) {
      own.push_back(key(i));
      things.push_back(i);
    }
  }
  std::sort(all.begin(), all.end());
  ASSERT_EQ(std::adjacent_find(all.begin(), all.end()), all.end());
  const CommonNumbers found = commonNumbers(own, bound, comm);
  EXPECT_EQ(found.count, std::int64_t(all.size()));
  for (std::size_t i = 0; i < own.size(); ++i) {
    EXPECT_EQ(all.at(std::size_t(found.numbers[i])), own[i]);
    int lowest = 0, highest = comm.size() - 1;
    while (!has(lowest, things[i]))
      ++lowest;
    while (!has(highest, things[i]))
      --highest;
    EXPECT_TRUE(found.owners[i] == lowest || found.owners[i] == highest);
  }
}

TEST(CommonNumbers, AreOwnedByOneRankEachInTurn)
{
  const Comm& comm = test::comm();
  std::vector<CommonKey> keys; // all ranks have all
  for (std::int64_t i = 0; i < numKeys; ++i)
    keys.push_back(key(i));
  const CommonNumbers found = commonNumbers(keys, bound, comm);
  Vector sums(found.owners.begin(), found.owners.end());
  comm.sum(sums);
  int last = 0;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    EXPECT_EQ(sums[i], found.owners[i] * comm.size()); // all ranks say the same
    last += found.owners[i] == comm.size() - 1 ? 1 : 0;
  }
  EXPECT_NEAR(last, comm.size() == 1 ? numKeys : numKeys / 2, 10);
}

TEST(CommonNumbers, OfNothingAreNone)
{
  const CommonNumbers found = commonNumbers({}, 0, test::comm());
  EXPECT_EQ(found.count, 0);
  EXPECT_TRUE(found.numbers.empty());
}

} // namespace ndframe

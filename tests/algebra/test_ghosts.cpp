// Who owns what this rank holds, and values from there.

#include <gtest/gtest.h>

#include "common/test_main.hpp"
#include "ndframe/algebra/dense.hpp"
#include "ndframe/algebra/ghosts.hpp"

namespace ndframe
{
namespace
{

using Global = IndexMap::Global;

constexpr Global size = 5'000'000'000, numUsed = 200;

/// Some numbers of a map, few of them small, each owned by a rank that nothing but this tells.
Global number(Global i)
{
  return i < 7 ? i : size - 1 - 3 * (numUsed - i);
}
int owner(Global i)
{
  return int(i * i % 11) % test::comm().size();
}

/// Owned ones, and as ghosts every third of the others.
IndexMap map()
{
  std::vector<Global> owned, needed;
  for (Global i = 0; i < numUsed; ++i)
    if (owner(i) == test::comm().rank())
      owned.push_back(number(i));
    else if (i % 3 == 0)
      needed.push_back(number(i));
  return {size, std::move(owned), std::move(needed)};
}

} // namespace

TEST(Ghosts, AreOwnedByTheRanksThatSaySo)
{
  std::vector<Global> asked;
  std::vector<int> expected;
  for (Global k = 0; k < numUsed; ++k) {
    const Global i = (k * 77 + test::comm().rank()) % numUsed;
    asked.push_back(number(i));
    expected.push_back(owner(i));
  }
  EXPECT_EQ(ownersOf(asked, map(), test::comm()), expected);
}

TEST(Ghosts, HaveTheValuesOfTheirOwners)
{
  const IndexMap held = map();
  Vector values;
  for (int i = 0; i < held.size(); ++i)
    for (const int part : {0, 1})
      values.push_back(held.owns(i) ? double(2 * held.global(i) + part) : -1.0);
  sharedGhosts(held, test::comm()).fetch([](int i) { return SharedValues::Place{2 * std::size_t(i), 2}; }, values);
  for (int i = 0; i < held.size(); ++i)
    for (const int part : {0, 1})
      EXPECT_EQ(values[2 * std::size_t(i) + std::size_t(part)], double(2 * held.global(i) + part));
  if (test::comm().size() > 1) {
    EXPECT_GT(held.size(), held.numOwned());
  }
}

} // namespace ndframe

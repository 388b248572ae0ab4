#include <cmath>

#include <gtest/gtest.h>

#include "common/test_main.hpp"
#include "ndframe/algebra/comm.hpp"
#include "ndframe/algebra/from_rank_zero.hpp"

namespace ndframe
{

TEST(Comm, ASingleProcessStartsNoMpiUntilItIsNeeded)
{
  const Comm& comm = test::comm();
  EXPECT_EQ(mpiIsRunning(), comm.size() > 1);
  EXPECT_EQ(Comm::single().size(), 1);
  EXPECT_EQ(Comm::single().rank(), 0);
  Vector values = {1.0};
  Comm::single().sum(values);
  EXPECT_EQ(mpiIsRunning(), comm.size() > 1);
}

TEST(Comm, StartMpiStartsItOnce)
{
  startMpi();
  startMpi();
  EXPECT_TRUE(mpiIsRunning());
}

TEST(Comm, SumsOverAllRanks)
{
  const Comm& comm = test::comm();
  const double n = comm.size(), sumOfRanks = n * (n - 1.0) / 2.0;
  Vector values = {1.0, double(comm.rank())};
  comm.sum(values);
  EXPECT_EQ(values, (Vector{n, sumOfRanks}));
  EXPECT_EQ(comm.sum(std::int64_t(comm.rank()) << 40), std::int64_t(sumOfRanks) << 40);
}

TEST(Comm, BroadcastsWhatRankZeroHasWhateverTheLength)
{
  const Comm& comm = test::comm();
  Vector values(std::size_t(comm.rank()), -1.0);
  std::string text = "other";
  if (comm.rank() == 0) {
    values = {1.0, 2.0, 3.0};
    text = "from rank 0";
  }
  comm.broadcast(values);
  comm.broadcast(text);
  EXPECT_EQ(values, (Vector{1.0, 2.0, 3.0}));
  EXPECT_EQ(text, "from rank 0");
}

TEST(Comm, RankZeroHandsOutToOneRankAfterTheOther)
{
  const Comm& comm = test::comm();
  std::vector<int> asked;
  const auto textFor = [](int rank) { return std::string(std::size_t(100'000 * rank), char('a' + rank)) + '\0'; };
  const std::string text = handedOut(comm, [&](int rank) {
    asked.push_back(rank);
    return textFor(rank);
  });
  EXPECT_EQ(text, textFor(comm.rank()));
  std::vector<int> all; // its own is the last
  for (int rank = 1; comm.rank() == 0 && rank <= comm.size(); ++rank)
    all.push_back(rank % comm.size());
  EXPECT_EQ(asked, all);
  EXPECT_EQ(handedOut(comm, [](int) { return std::string(); }), "");
}

TEST(Comm, ASingleCommInsideMpirunStaysAlone)
{
  Vector values = {double(test::comm().rank())};
  Comm::single().sum(values);
  EXPECT_EQ(values[0], test::comm().rank());
}

} // namespace ndframe

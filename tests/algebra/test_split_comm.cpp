// A program hands in a part of its processes: several parts solve different bodies at a time.

#include <gtest/gtest.h>

#include "algebra/sample_bodies.hpp"
#include "common/test_main.hpp"

namespace ndframe
{
namespace
{

int part()
{
  return test::comm().rank() % 2;
}

class SplitSolvers : public testing::TestWithParam<const char*>
{};

TEST(SplitComm, PartsSumAndBroadcastAmongThemselves)
{
  const Comm comm = test::comm().split(part());
  const int all = test::comm().size();
  EXPECT_EQ(comm.size(), part() == 0 ? (all + 1) / 2 : all / 2);
  if (all > 1) {
    EXPECT_EQ(Comm::of(comm.communicator()).size(), comm.size());
  }
  EXPECT_EQ(comm.rank(), test::comm().rank() / 2);
  EXPECT_EQ(comm.sum(std::int64_t(1)), comm.size());
  std::string text = comm.rank() == 0 ? std::string(std::size_t(1 + part()), 'x') : std::string();
  comm.broadcast(text);
  EXPECT_EQ(text, part() == 0 ? "x" : "xx");
}

TEST_P(SplitSolvers, PartsSolveDifferentBodiesAtATime)
{
  const std::vector<int> cells = part() == 0 ? std::vector<int>{4, 3} : std::vector<int>{6, 2};
  const auto schurOn = [&](const Comm& comm, const std::string& solver) {
    const test::SampleBody body = test::trussBody(cells, comm);
    const SolverProblem problem = body.problem(test::Support::Clamp);
    Ledger ledger;
    return test::makeSolver(solver)->factor(problem, comm, ledger)->schurComplement();
  };
  const DenseMatrix parallel = schurOn(test::comm().split(part()), GetParam()),
                    alone = schurOn(Comm::single(), "Cholmod");
  ASSERT_EQ(parallel.cols(), alone.cols());
  const double largest = largestEntry(alone.column(0));
  for (int j = 0; j < alone.cols(); ++j)
    for (int i = 0; i < alone.rows(); ++i)
      EXPECT_NEAR(parallel(i, j), alone(i, j), 1e-7 * largest);
}

INSTANTIATE_TEST_SUITE_P(All, SplitSolvers, testing::Values("Mumps", "Krylov"));

} // namespace
} // namespace ndframe

// How far CHOLMOD says to be, by the parallel regions that it enters.

#include <algorithm>
#include <optional>

#include <gmock/gmock.h>

#include "cholmod_factor.hpp"
#include "serial_openmp.hpp"

namespace ndframe
{

namespace
{

/// Five-point stencil on a grid of n x n, column by column.
UpperTriangle grid(int n)
{
  UpperTriangle A;
  A.colPtr.push_back(0);
  for (int column = 0; column < n * n; ++column) {
    if (column >= n) {
      A.rows.push_back(column - n);
      A.values.push_back(-1.0);
    }
    if (column % n > 0) {
      A.rows.push_back(column - 1);
      A.values.push_back(-1.0);
    }
    A.rows.push_back(column);
    A.values.push_back(4.5);
    A.colPtr.push_back(int(A.rows.size()));
  }
  return A;
}

} // namespace

/// The regions that are expected are those that are entered, and what is told rises to all that there is.
TEST(FactorProgress, KnowsTheRegionsAndTellsTheShareOfTheWork)
{
  for (const int n : {20, 90}) {
    UpperTriangle A = grid(n);
    cholmod_common common;
    startCholmod(common);
    common.method[0].ordering = CHOLMOD_AMD;
    cholmod_sparse view = viewOf(A);
    cholmod_factor* factor = cholmod_analyze(&view, &common);
    std::vector<double> told;
    double all = 0.0;
    std::optional<FactorProgress> progress;
    progress.emplace(*factor, [&](double done, double of) {
      told.push_back(done);
      all = of;
    });
    {
      const SerialOpenMp serial([&] { progress->enterRegion(); });
      cholmod_factorize(&view, factor, &common);
    }
    EXPECT_EQ(progress->regions(), progress->expected()) << n;
    EXPECT_EQ(progress->share(), 1.0);
    EXPECT_THAT(told, testing::SizeIs(testing::Ge(5u)));
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_LE(told.back(), all);
    EXPECT_GE(told.back(), 0.98 * all);
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }
}

} // namespace ndframe

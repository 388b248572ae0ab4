// Elimination of the closed conditions: what it promises, on random rows of few entries.

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "ndframe/subdomain/closed_rows.hpp"

namespace ndframe
{
namespace
{

double value(std::mt19937& random)
{
  return std::uniform_real_distribution<double>(-1.0, 1.0)(random);
}

double times(const SparseRow& row, const Vector& v)
{
  double sum = 0.0;
  for (const auto& [column, coefficient] : row)
    sum += coefficient * v[std::size_t(column)];
  return sum;
}

/// Rows of two to four entries over few variables, so that they share them; values that some v has.
struct Sample
{
  std::vector<SparseRow> rows;
  std::vector<int> chosen;
  Vector values;
  int numVariables;

  explicit Sample(unsigned seed)
  {
    std::mt19937 random(seed);
    numVariables = 4 + int(random() % 20);
    Vector v;
    for (int k = 0; k < numVariables; ++k)
      v.push_back(value(random));
    for (int r = 0; r < numVariables; ++r) {
      SparseRow row;
      for (int e = 0; e < 2 + int(random() % 3); ++e)
        row.emplace_back(int(random() % unsigned(numVariables)), e == 0 ? 1.0 : -std::round(4.0 * value(random)) / 2.0);
      values.push_back(times(row, v));
      rows.push_back(row);
      if (random() % 2 == 0)
        chosen.push_back(r);
    }
    rows.push_back(rows.front()); // one condition twice
    values.push_back(values.front());
    chosen.insert(chosen.end(), {0, int(rows.size()) - 1});
  }
  ClosedRows eliminated() const { return {rows, chosen, values, numVariables}; }
};

class ClosedRowsOf : public testing::TestWithParam<int>
{
public:
  Vector random(std::size_t size) const
  {
    std::mt19937 generator(unsigned(GetParam()) + 1000u);
    Vector v;
    for (std::size_t i = 0; i < size; ++i)
      v.push_back(value(generator));
    return v;
  }
  const Sample sample{unsigned(GetParam())};
  const ClosedRows closed = sample.eliminated();
};

} // namespace

TEST_P(ClosedRowsOf, HoldForWhateverIsFree)
{
  const Vector v = closed.expanded(random(std::size_t(closed.numFree())));
  for (const int row : sample.chosen)
    EXPECT_NEAR(times(sample.rows[std::size_t(row)], v), sample.values[std::size_t(row)], 1e-8);
  const Vector z = closed.direction(random(std::size_t(closed.numFree())));
  for (const int row : sample.chosen)
    EXPECT_NEAR(times(sample.rows[std::size_t(row)], z), 0.0, 1e-8);
}

TEST_P(ClosedRowsOf, ReduceByTheTransposedDirection)
{
  const Vector q = random(std::size_t(sample.numVariables)), y = random(std::size_t(closed.numFree()));
  EXPECT_NEAR(dot(closed.reduced(q), y), dot(q, closed.direction(y)), 1e-9);
  const Vector z = closed.direction(y);
  for (int k = 0; k < sample.numVariables; ++k) {
    double sum = 0.0;
    for (const auto& [number, share] : closed.inFree(k))
      sum += share * y[std::size_t(number)];
    EXPECT_NEAR(sum, z[std::size_t(k)], 1e-9);
  }
}

/// q = B^T r has no part along what stays free, and its forces give it back; where rows follow from others there are
/// several r, all with this q.
TEST_P(ClosedRowsOf, GiveBackTheForces)
{
  Vector q(std::size_t(sample.numVariables), 0.0), back = q;
  const Vector r = random(sample.rows.size());
  const auto add = [&](int row, double force, Vector& to) {
    for (const auto& [column, coefficient] : sample.rows[std::size_t(row)])
      to[std::size_t(column)] += coefficient * force;
  };
  for (const int row : sample.chosen)
    add(row, r[std::size_t(row)], q);
  EXPECT_LT(largestEntry(closed.reduced(q)), 1e-8);
  const Vector forces = closed.forces(q);
  for (std::size_t row = 0; row < forces.size(); ++row)
    add(int(row), forces[row], back);
  for (std::size_t k = 0; k < q.size(); ++k)
    EXPECT_NEAR(back[k], q[k], 1e-8);
}

/// Rows as of an inverse mass matrix: every coefficient counts that double precision can tell from zero.
TEST(ClosedRows, HoldToRoundOffWhereCoefficientsDecay)
{
  constexpr int size = 40;
  std::vector<SparseRow> rows(size);
  std::vector<int> all;
  Vector values(size, 0.0), free(size, 1.0);
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j)
      for (const int side : {0, 1})
        rows[std::size_t(i)].emplace_back(side * size + j, (side == 0 ? 1.0 : -1.0) * std::pow(-0.4, std::abs(i - j)));
    all.push_back(i);
  }
  const ClosedRows closed(rows, all, values, 2 * size);
  ASSERT_EQ(closed.numFree(), size);
  for (std::size_t i = 0; i < free.size(); ++i)
    free[i] = std::sin(double(i));
  const Vector v = closed.expanded(free);
  for (const SparseRow& row : rows)
    EXPECT_NEAR(times(row, v), 0.0, 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Samples, ClosedRowsOf, testing::Range(0, 40));

} // namespace ndframe

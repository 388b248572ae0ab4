// Sparse Cholesky and sparse columns against dense ones.

#include <random>

#include <gtest/gtest.h>

#include "ndframe/algebra/sparse_cholesky.hpp"
#include "ndframe/algebra/sparse_columns.hpp"

namespace ndframe
{
namespace
{

double value(std::mt19937& random)
{
  return std::uniform_real_distribution<double>(-1.0, 1.0)(random);
}

/// Sum of random small blocks u u^T: `A` and its entries, places named several times.
SymmetricEntries randomEntries(int size, int blocks, DenseMatrix& A, std::mt19937& random)
{
  SymmetricEntries entries;
  entries.size = size;
  A = DenseMatrix(size, size);
  const auto add = [&](int i, int j, double x) {
    if (i <= j)
      entries.add(i, j, x);
    A(i, j) += x;
  };
  for (int k = 0; k < size; ++k)
    add(k, k, 1.0);
  for (int b = 0; b < blocks; ++b) {
    const int i = int(random() % unsigned(size)), j = int(random() % unsigned(size));
    const double u = value(random), v = value(random);
    add(i, i, u * u);
    add(j, j, v * v);
    if (i != j) {
      add(i, j, u * v);
      add(j, i, u * v);
    }
  }
  return entries;
}

} // namespace

TEST(SparseCholesky, SolvesLikeTheDenseOne)
{
  std::mt19937 random(3);
  for (const int size : {1, 2, 7, 40, 150}) {
    DenseMatrix A(0, 0);
    const SymmetricEntries entries = randomEntries(size, 3 * size, A, random);
    Vector b;
    for (int k = 0; k < size; ++k)
      b.push_back(value(random));
    const Vector x = SparseCholesky(entries).solve(b), y = DenseCholesky(A).solve(b);
    for (int k = 0; k < size; ++k)
      EXPECT_NEAR(x[std::size_t(k)], y[std::size_t(k)], 1e-12);
  }
  EXPECT_TRUE(SparseCholesky(SymmetricEntries()).solve({}).empty());
}

TEST(SparseCholesky, RefusesWhatIsSingular)
{
  SymmetricEntries spring; // between two free points
  spring.size = 2;
  spring.add(0, 0, 2.0);
  spring.add(0, 1, -2.0);
  spring.add(1, 1, 2.0);
  EXPECT_THROW(SparseCholesky{spring}, NotPositiveDefinite);
  spring.add(1, 1, 1e-9);
  EXPECT_NO_THROW(SparseCholesky{spring});
  SymmetricEntries nothing;
  nothing.size = 1;
  nothing.add(0, 0, 0.0);
  EXPECT_THROW(SparseCholesky{nothing}, NotPositiveDefinite);
}

TEST(SparseColumns, AreTheDenseMatrix)
{
  std::mt19937 random(4);
  DenseMatrix A(9, 5);
  SparseColumns sparse(9, 5);
  for (int entry = 0; entry < 20; ++entry) {
    const int i = int(random() % 9), j = int(random() % 5);
    sparse(i, j) = A(i, j) = value(random);
  }
  const SparseColumns converted = A;
  Vector x(9), y(5);
  for (double& entry : x)
    entry = value(random);
  for (double& entry : y)
    entry = value(random);
  const Vector Ay = multiply(A, y), Atx = multiplyTransposed(A, x);
  for (const SparseColumns* S : {static_cast<const SparseColumns*>(&sparse), &converted}) {
    for (std::size_t i = 0; i < x.size(); ++i)
      EXPECT_NEAR(S->times(y)[i], Ay[i], 1e-15);
    for (std::size_t j = 0; j < y.size(); ++j) {
      EXPECT_NEAR(S->transposedTimes(x)[j], Atx[j], 1e-15);
      EXPECT_GE(S->magnitude(int(j), x), std::abs(Atx[j]) - 1e-15);
      for (int i = 0; i < 9; ++i)
        EXPECT_EQ((*S)(i, int(j)), A(i, int(j)));
    }
  }
}

} // namespace ndframe

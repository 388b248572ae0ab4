#include <gtest/gtest.h>

#include "algebra/sample_bodies.hpp"
#include "ndframe/algebra/band.hpp"

namespace ndframe
{

namespace
{

/// Diagonally dominant, all entries within the band different from zero.
BandMatrix positiveDefinite(int size, int bandwidth)
{
  const Vector values = test::randomVector(std::size_t(size) * std::size_t(bandwidth + 1), 7);
  BandMatrix A(size, bandwidth);
  std::size_t next = 0;
  for (int j = 0; j < size; ++j)
    for (int i = j; i < std::min(size, j + bandwidth + 1); ++i)
      A(i, j) = values[next++] + (i == j ? 2.0 * bandwidth + 2.0 : 0.0);
  return A;
}

DenseMatrix dense(const BandMatrix& A)
{
  DenseMatrix full(A.size(), A.size());
  for (int j = 0; j < A.size(); ++j)
    for (int i = std::max(0, j - A.bandwidth()); i < std::min(A.size(), j + A.bandwidth() + 1); ++i)
      full(i, j) = A(i, j);
  return full;
}

} // namespace

TEST(Band, SolveInvertsTheProduct)
{
  for (const int bandwidth : {0, 1, 4}) {
    const BandMatrix A = positiveDefinite(30, bandwidth);
    const Vector x = test::randomVector(30, 9);
    EXPECT_LT(test::relativeDifference(BandCholesky(A).solve(multiply(dense(A), x)), x), 1e-14);
  }
}

TEST(Band, BandMayBeWiderThanTheMatrix)
{
  BandMatrix A(2, 4);
  A(0, 0) = 2.0, A(1, 0) = 1.0, A(1, 1) = 2.0;
  EXPECT_LT(test::relativeDifference(BandCholesky(A).solve({3.0, 3.0}), {1.0, 1.0}), 1e-15);
}

TEST(Band, NamesTheRowThatIsNotPositive)
{
  BandMatrix A = positiveDefinite(6, 2);
  A(4, 4) = -1.0;
  try {
    BandCholesky factor(A);
    FAIL() << "not positive definite";
  } catch (const NotPositiveDefinite& failure) {
    EXPECT_EQ(failure.row, 4);
  }
}

TEST(Band, OfNothingSolvesNothing)
{
  EXPECT_TRUE(BandCholesky(BandMatrix(0, 1)).solve({}).empty());
}

TEST(Band, RefusesShapesThatDoNotMatch)
{
  EXPECT_THROW(BandCholesky(positiveDefinite(2, 1)).solve(Vector(3)), InternalError);
}

} // namespace ndframe

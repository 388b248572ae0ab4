#include <gtest/gtest.h>

#include "algebra/sample_bodies.hpp"
#include "ndframe/algebra/symmetric_operator.hpp"

namespace ndframe
{

namespace
{

/// The second difference matrix of a chain of n nodes without supports: singular, constants in the null space.
DenseMatrix chain(int n)
{
  DenseMatrix A(n, n);
  for (int i = 0; i + 1 < n; ++i) {
    A(i, i) += 1.0;
    A(i + 1, i + 1) += 1.0;
    A(i, i + 1) = A(i + 1, i) = -1.0;
  }
  return A;
}

} // namespace

TEST(DenseOperator, AppliesTheMatrix)
{
  const auto A = makeDenseOperator(chain(4));
  EXPECT_EQ(A->size(), 4);
  EXPECT_EQ(A->apply({1.0, 2.0, 4.0, 8.0}), (Vector{-1.0, -1.0, -2.0, 4.0}));
}

TEST(DenseOperator, InverseOnASetSolvesItsEquationsAndVanishesOutside)
{
  const auto A = makeDenseOperator(chain(6));
  const std::vector<char> isFree = {0, 1, 1, 0, 1, 1};
  const Vector b = test::randomVector(6, 1), x = A->inverseOn(isFree, 0.0)->solve(b), product = A->apply(x);
  for (std::size_t i = 0; i < 6; ++i)
    if (isFree[i])
      EXPECT_NEAR(product[i], b[i], 1e-14);
    else
      EXPECT_EQ(x[i], 0.0);
}

TEST(DenseOperator, ShiftIsAddedToTheDiagonal)
{
  const auto A = makeDenseOperator(chain(4));
  const Vector b = test::randomVector(4, 2), x = A->inverseOn({1, 1, 1, 1}, 0.5)->solve(b), product = A->apply(x);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(product[i] + 0.5 * x[i], b[i], 1e-14);
}

TEST(DenseOperator, ShowsItsMatrix)
{
  const auto A = makeDenseOperator(chain(3));
  ASSERT_NE(A->dense(), nullptr);
  EXPECT_EQ((*A->dense())(1, 2), -1.0);
}

TEST(DenseOperator, InverseOnNothingIsZero)
{
  const auto A = makeDenseOperator(chain(3));
  EXPECT_EQ(A->inverseOn({0, 0, 0}, 0.0)->solve({1.0, 2.0, 3.0}), Vector(3, 0.0));
}

TEST(DenseOperator, SingularSetIsRefusedWithARowOfTheMatrix)
{
  DenseMatrix A = chain(5);
  A(1, 1) = 0.0;
  try {
    makeDenseOperator(A)->inverseOn({0, 1, 0, 1, 1}, 0.0);
    FAIL();
  } catch (const NotPositiveDefinite& failure) {
    EXPECT_EQ(failure.row, 1);
  }
  EXPECT_THROW(makeDenseOperator(chain(5))->inverseOn({1, 1, 1, 1, 1}, 0.0), NotPositiveDefinite);
}

} // namespace ndframe

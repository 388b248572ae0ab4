#include <cmath>

#include <gtest/gtest.h>

#include "algebra/sample_bodies.hpp"
#include "ndframe/algebra/dense.hpp"

namespace ndframe
{

namespace
{

DenseMatrix randomMatrix(int rows, int cols, unsigned seed)
{
  const Vector values = test::randomVector(std::size_t(rows) * std::size_t(cols), seed);
  DenseMatrix A(rows, cols);
  std::copy(values.begin(), values.end(), A.data());
  return A;
}

/// B B^T + I
DenseMatrix positiveDefinite(int n)
{
  const DenseMatrix B = randomMatrix(n, n, 3);
  DenseMatrix A(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      A(i, j) = i == j ? 1.0 : 0.0;
      for (int k = 0; k < n; ++k)
        A(i, j) += B(i, k) * B(j, k);
    }
  return A;
}

int failingRow(const DenseMatrix& A)
{
  try {
    DenseCholesky factor(A);
    return -1;
  } catch (const NotPositiveDefinite& failure) {
    return failure.row;
  }
}

DenseMatrix diagonalMatrix(const Vector& d)
{
  DenseMatrix A(int(d.size()), int(d.size()));
  for (int i = 0; i < A.rows(); ++i)
    A(i, i) = d[std::size_t(i)];
  return A;
}

} // namespace

TEST(Dense, ProductIsTheSumOverColumns)
{
  const DenseMatrix A = randomMatrix(4, 3, 1);
  const Vector x = {2.0, -1.0, 0.5}, y = multiply(A, x);
  ASSERT_EQ(y.size(), 4u);
  for (int i = 0; i < 4; ++i)
    EXPECT_NEAR(y[std::size_t(i)], 2.0 * A(i, 0) - A(i, 1) + 0.5 * A(i, 2), 1e-15);
}

TEST(Dense, ProductsOfEmptyMatricesAreZero)
{
  EXPECT_TRUE(multiply(DenseMatrix(0, 3), Vector(3, 1.0)).empty());
  EXPECT_EQ(multiply(DenseMatrix(2, 0), Vector()), Vector(2, 0.0));
  EXPECT_TRUE(multiplySymmetric(DenseMatrix(0, 0), {}).empty());
}

TEST(Dense, SymmetricProductEqualsGeneralProduct)
{
  const DenseMatrix A = positiveDefinite(7);
  const Vector x = test::randomVector(7, 5);
  EXPECT_LT(test::relativeDifference(multiplySymmetric(A, x), multiply(A, x)), 1e-15);
}

TEST(Dense, ProductRefusesShapesThatDoNotMatch)
{
  EXPECT_THROW(multiply(DenseMatrix(2, 3), Vector(2)), InternalError);
  EXPECT_THROW(multiplyTransposed(DenseMatrix(2, 3), Vector(3)), InternalError);
  EXPECT_THROW(multiplySymmetric(DenseMatrix(2, 3), Vector(3)), InternalError);
}

TEST(Dense, ProductsOfMatricesAreProductsWithTheirColumns)
{
  const DenseMatrix A = randomMatrix(4, 3, 6), B = randomMatrix(3, 2, 7), C = randomMatrix(4, 2, 8);
  const DenseMatrix AB = multiply(A, B), AtC = multiplyTransposed(A, C);
  ASSERT_EQ(AtC.rows(), 3);
  for (int j = 0; j < 2; ++j) {
    EXPECT_LT(test::relativeDifference(AB.column(j), multiply(A, B.column(j))), 1e-15);
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(AtC(i, j), dot(A.column(i), C.column(j)), 1e-15);
    EXPECT_LT(test::relativeDifference(AtC.column(j), multiplyTransposed(A, C.column(j))), 1e-15);
  }
  EXPECT_EQ(multiply(DenseMatrix(2, 0), DenseMatrix(0, 3)).column(2), Vector(2, 0.0));
  EXPECT_EQ(multiplyTransposed(DenseMatrix(0, 2), Vector()), Vector(2, 0.0));
  EXPECT_THROW(multiply(A, C), InternalError);
  EXPECT_THROW(multiplyTransposed(A, B), InternalError);
}

TEST(DenseCholesky, SolveInvertsTheProduct)
{
  const DenseMatrix A = positiveDefinite(20);
  const Vector x = test::randomVector(20, 9);
  EXPECT_LT(test::relativeDifference(DenseCholesky(A).solve(multiply(A, x)), x), 1e-12);
}

TEST(DenseCholesky, HalvesOfASolutionMakeTheWholeAndCarryTheEnergy)
{
  const DenseMatrix A = positiveDefinite(12);
  const Vector b = test::randomVector(12, 4);
  const DenseCholesky factor(A);
  const Vector half = factor.solveLower(b);
  EXPECT_LT(test::relativeDifference(factor.solveUpper(half), factor.solve(b)), 1e-14);
  EXPECT_NEAR(dot(half, half) / dot(b, factor.solve(b)), 1.0, 1e-14);
}

TEST(DenseCholesky, NamesTheFirstVanishingPivot)
{
  EXPECT_EQ(failingRow(diagonalMatrix({1.0, 2.0, -1.0, 0.0})), 2);
  EXPECT_EQ(failingRow(diagonalMatrix({1.0, 1e-14, 1.0})), 1);
  EXPECT_EQ(failingRow(DenseMatrix(2, 2)), 0);
  EXPECT_EQ(failingRow(diagonalMatrix({1.0, 1e-12, 1.0})), -1);
}

TEST(DenseCholesky, JudgesPivotsWhateverTheUnits)
{
  EXPECT_EQ(failingRow(diagonalMatrix({1e-30, 2e-30})), -1);
  EXPECT_EQ(failingRow(diagonalMatrix({1e30, 1e10})), 1);
}

TEST(DenseCholesky, OfNothingSolvesNothing)
{
  EXPECT_TRUE(DenseCholesky(DenseMatrix(0, 0)).solve({}).empty());
}

TEST(NullSpace, IsOrthonormalAndMappedToZero)
{
  DenseMatrix A = randomMatrix(9, 4, 2);
  for (int i = 0; i < 9; ++i) // two dependent columns
  {
    A(i, 2) = A(i, 0) - 2.0 * A(i, 1);
    A(i, 3) = 3.0 * A(i, 1);
  }
  const DenseMatrix N = nullSpace(A, 1e-12);
  ASSERT_EQ(N.cols(), 2);
  for (int a = 0; a < 2; ++a) {
    EXPECT_LT(norm(multiply(A, N.column(a))), 1e-13);
    for (int b = 0; b < 2; ++b)
      EXPECT_NEAR(dot(N.column(a), N.column(b)), a == b ? 1.0 : 0.0, 1e-14);
  }
}

TEST(NullSpace, OfAWideMatrixHasAtLeastTheMissingRows)
{
  const DenseMatrix A = randomMatrix(2, 5, 4), N = nullSpace(A, 1e-12);
  ASSERT_EQ(N.cols(), 3);
  for (int k = 0; k < 3; ++k)
    EXPECT_LT(norm(multiply(A, N.column(k))), 1e-14);
}

TEST(NullSpace, OfZeroOrOfNoRowsIsEverything)
{
  EXPECT_EQ(nullSpace(DenseMatrix(0, 3), 1e-12).cols(), 3);
  EXPECT_EQ(nullSpace(DenseMatrix(4, 3), 1e-12).cols(), 3);
  EXPECT_EQ(nullSpace(DenseMatrix(4, 0), 1e-12).cols(), 0);
}

TEST(NullSpace, OfAFullRankMatrixIsEmptyWhateverTheUnits)
{
  DenseMatrix A = randomMatrix(5, 3, 8);
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 5; ++i)
      A(i, j) *= 1e-40;
  EXPECT_EQ(nullSpace(A, 1e-12).cols(), 0);
}

TEST(Dense, DotAndNormAreEuclidean)
{
  EXPECT_EQ(dot({1.0, 2.0}, {3.0, -1.0}), 1.0);
  EXPECT_EQ(norm({3.0, 4.0}), 5.0);
  EXPECT_EQ(norm({}), 0.0);
  EXPECT_NEAR(norm({3e200, 4e200}) / 5e200, 1.0, 1e-15);
}

TEST(PseudoInverse, FulfilsThePenroseConditions)
{
  DenseMatrix tall = randomMatrix(7, 4, 9);
  for (int i = 0; i < 7; ++i)
    tall(i, 3) = tall(i, 0) - tall(i, 1); // rank 3
  DenseMatrix wide(4, 7);
  for (int i = 0; i < 7; ++i)
    for (int j = 0; j < 4; ++j)
      wide(j, i) = tall(i, j);
  for (const DenseMatrix& A : {tall, wide, DenseMatrix(3, 2)}) {
    const DenseMatrix P = pseudoInverse(A, 1e-12), AP = multiply(A, P), PA = multiply(P, A);
    const DenseMatrix again = multiply(AP, A), inverse = multiply(PA, P);
    ASSERT_EQ(P.rows(), A.cols());
    for (int i = 0; i < A.rows(); ++i)
      for (int j = 0; j < A.cols(); ++j) {
        EXPECT_NEAR(again(i, j), A(i, j), 1e-13);
        EXPECT_NEAR(inverse(j, i), P(j, i), 1e-13);
      }
    for (int i = 0; i < AP.rows(); ++i)
      for (int j = 0; j < i; ++j)
        EXPECT_NEAR(AP(i, j), AP(j, i), 1e-13);
    for (int i = 0; i < PA.rows(); ++i)
      for (int j = 0; j < i; ++j)
        EXPECT_NEAR(PA(i, j), PA(j, i), 1e-13);
  }
}

TEST(PseudoInverse, OfNothingIsNothing)
{
  const DenseMatrix P = pseudoInverse(DenseMatrix(0, 3), 1e-12);
  EXPECT_EQ(P.rows(), 3);
  EXPECT_EQ(P.cols(), 0);
}

TEST(SymmetricEigenvalues, AreThoseOfAKnownMatrixInAscendingOrder)
{
  DenseMatrix A(3, 3);
  const double entries[3][3] = {{2, -1, 0}, {-1, 2, -1}, {0, -1, 2}};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j <= i; ++j)
      A(i, j) = entries[i][j];
  const Vector values = symmetricEigenvalues(A);
  ASSERT_EQ(values.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(values[k], 2.0 + (double(k) - 1.0) * std::sqrt(2.0), 1e-14);
  EXPECT_TRUE(symmetricEigenvalues(DenseMatrix()).empty());
}

} // namespace ndframe

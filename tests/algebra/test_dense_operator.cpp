#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "algebra/sample_bodies.hpp"
#include "algebra/spring_chain.hpp"
#include "ndframe/algebra/symmetric_operator.hpp"

namespace ndframe
{

TEST(DenseOperator, AppliesTheMatrix)
{
  const auto A = makeDenseOperator(test::springChain(4));
  EXPECT_EQ(A->size(), 4);
  EXPECT_EQ(A->apply({1.0, 2.0, 4.0, 8.0}), (Vector{-1.0, -1.0, -2.0, 4.0}));
}

TEST(DenseOperator, InverseOnASetSolvesItsEquationsAndVanishesOutside)
{
  const auto A = makeDenseOperator(test::springChain(6));
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
  const auto A = makeDenseOperator(test::springChain(4));
  const Vector b = test::randomVector(4, 2), x = A->inverseOn({1, 1, 1, 1}, 0.5)->solve(b), product = A->apply(x);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(product[i] + 0.5 * x[i], b[i], 1e-14);
}

TEST(DenseOperator, ShowsItsMatrix)
{
  const auto A = makeDenseOperator(test::springChain(3));
  ASSERT_NE(A->dense(), nullptr);
  EXPECT_EQ((*A->dense())(1, 2), -1.0);
}

TEST(DenseOperator, InverseOnNothingIsZero)
{
  const auto A = makeDenseOperator(test::springChain(3));
  EXPECT_EQ(A->inverseOn({0, 0, 0}, 0.0)->solve({1.0, 2.0, 3.0}), Vector(3, 0.0));
}

/// Sets that wander about: rows leave and come back, alone and many at once.
TEST(DenseOperator, MovedInverseIsThatOfTheNewSet)
{
  for (const double shift : {0.0, 0.3}) {
    DenseMatrix matrix = test::springChain(500);
    for (int i = 0; i < 500; ++i)
      for (int j = 0; j < 500; ++j)
        matrix(i, j) += std::exp(-0.05 * std::abs(i - j));
    const auto A = makeDenseOperator(matrix);
    std::mt19937 random(7);
    std::vector<char> isFree(500);
    for (char& flag : isFree)
      flag = char(random() % 5 != 0);
    auto inverse = A->inverseOn(isFree, shift);
    int moves = 0;
    for (int step = 0; step < 40; ++step) {
      for (unsigned flips = 1 + random() % 4; flips > 0; --flips)
        isFree[random() % (step < 20 ? 30 : 500)] ^= 1;
      const bool isMoved = inverse->moveTo(isFree);
      moves += int(isMoved);
      if (!isMoved)
        inverse = A->inverseOn(isFree, shift);
      const Vector b = test::randomVector(500, unsigned(step)), x = inverse->solve(b),
                   fresh = A->inverseOn(isFree, shift)->solve(b);
      for (std::size_t i = 0; i < 500; ++i)
        if (isFree[i])
          ASSERT_NEAR(x[i], fresh[i], 1e-10 * largestEntry(fresh)) << step;
        else
          ASSERT_EQ(x[i], 0.0);
    }
    EXPECT_GT(moves, 30);
    EXPECT_LT(moves, 40); // after so many other rows a new factor is cheaper
  }
}

TEST(DenseOperator, InverseIsNotMovedToSingularSets)
{
  const auto A = makeDenseOperator(test::springChain(300));
  std::vector<char> isFree(300, 1);
  isFree[17] = 0;
  const auto inverse = A->inverseOn(isFree, 0.0);
  const Vector b = test::randomVector(300, 3), before = inverse->solve(b);
  EXPECT_FALSE(inverse->moveTo(std::vector<char>(300, 1)));
  EXPECT_EQ(inverse->solve(b), before);
  isFree[18] = 0; // another row holds it instead
  EXPECT_TRUE(inverse->moveTo(isFree));
  isFree[17] = 1;
  EXPECT_TRUE(inverse->moveTo(isFree));
  const Vector product = A->apply(inverse->solve(b));
  for (std::size_t i = 0; i < 300; ++i)
    if (isFree[i]) {
      EXPECT_NEAR(product[i], b[i], 1e-9);
    }
}

TEST(DenseOperator, InversesOfOneSetShareItsFactorAndNothingElse)
{
  const auto A = makeDenseOperator(test::springChain(300));
  std::vector<char> isFree(300, 1), other;
  isFree[17] = 0;
  other = isFree;
  other[40] = 0;
  Vector b(300, 1.0);
  b[150] = -3.0;
  const auto first = A->inverseOn(isFree, 0.0), second = A->inverseOn(isFree, 0.0);
  const Vector x = first->solve(b);
  EXPECT_EQ(second->solve(b), x);
  EXPECT_TRUE(first->moveTo(other));
  EXPECT_EQ(second->solve(b), x);
  const auto third = A->inverseOn(other, 0.0), shifted = A->inverseOn(other, 1.0); // other factors
  EXPECT_EQ(second->solve(b), x);
  const Vector moved = first->solve(b), anew = third->solve(b);
  for (std::size_t i = 0; i < 300; ++i)
    EXPECT_NEAR(moved[i], anew[i], 1e-9 * std::abs(anew[i])) << i;
  EXPECT_LT(std::abs(shifted->solve(b)[150]), std::abs(anew[150]));
}

TEST(DenseOperator, SmallInversesAreMadeAnew)
{
  const auto A = makeDenseOperator(test::springChain(20));
  const auto inverse = A->inverseOn(std::vector<char>(20, 0), 0.0);
  EXPECT_FALSE(inverse->moveTo(std::vector<char>(20, 0)));
}

TEST(DenseOperator, SingularSetIsRefusedWithARowOfTheMatrix)
{
  DenseMatrix A = test::springChain(5);
  A(1, 1) = 0.0;
  try {
    makeDenseOperator(A)->inverseOn({0, 1, 0, 1, 1}, 0.0);
    FAIL();
  } catch (const NotPositiveDefinite& failure) {
    EXPECT_EQ(failure.row, 1);
  }
  EXPECT_THROW(makeDenseOperator(test::springChain(5))->inverseOn({1, 1, 1, 1, 1}, 0.0), NotPositiveDefinite);
}

} // namespace ndframe

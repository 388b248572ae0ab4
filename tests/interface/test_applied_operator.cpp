#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algebra/sample_bodies.hpp"
#include "algebra/spring_chain.hpp"
#include "interface/box_bodies.hpp"
#include "ndframe/base/diagnostics.hpp"

using namespace ndframe;
using namespace ndframe::test;

TEST(AppliedOperator, InverseOnASetSolvesItsEquationsAndVanishesOutside)
{
  const auto A = appliedOnly(springChain(7));
  const std::vector<char> isFree = {0, 1, 1, 0, 1, 1, 1};
  const Vector b = randomVector(7, 1), x = A->inverseOn(isFree, 0.0)->solve(b), product = A->apply(x);
  for (std::size_t i = 0; i < 7; ++i)
    if (isFree[i])
      EXPECT_NEAR(product[i], b[i], 1e-13);
    else
      EXPECT_EQ(x[i], 0.0);
}

TEST(AppliedOperator, ShiftIsAddedToTheDiagonal)
{
  const auto A = appliedOnly(springChain(5));
  const Vector b = randomVector(5, 2), x = A->inverseOn(std::vector<char>(5, 1), 0.5)->solve(b);
  const Vector product = A->apply(x);
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(product[i] + 0.5 * x[i], b[i], 1e-13);
}

TEST(AppliedOperator, InverseIsThatOfTheStoredMatrix)
{
  const std::vector<char> isFree = {1, 0, 1, 1, 1, 0, 1, 1};
  const Vector b = randomVector(8, 3);
  const Vector stored = makeDenseOperator(springChain(8, 0.3))->inverseOn(isFree, 0.0)->solve(b);
  EXPECT_LT(relativeDifference(appliedOnly(springChain(8, 0.3))->inverseOn(isFree, 0.0)->solve(b), stored), 1e-12);
}

TEST(AppliedOperator, SingularSetIsNotPositiveDefinite)
{
  const auto A = appliedOnly(springChain(5));
  const auto inverse = A->inverseOn(std::vector<char>(5, 1), 0.0);
  EXPECT_THROW(inverse->solve(Vector(5, 1.0)), NotPositiveDefinite);
  for (unsigned seed = 0; seed < 20; ++seed)
    EXPECT_THROW(inverse->solve(randomVector(5, seed)), NotPositiveDefinite) << "seed " << seed;
}

TEST(AppliedOperator, InverseOnNothingIsZero)
{
  EXPECT_EQ(appliedOnly(springChain(3, 1.0))->inverseOn({0, 0, 0}, 0.0)->solve({1.0, 2.0, 3.0}), Vector(3, 0.0));
}

TEST(AppliedOperator, StiffnessesTooFarApartAreNotConverged)
{
  DenseMatrix A(300, 300);
  for (int i = 0; i < 300; ++i)
    A(i, i) = std::pow(1e-12, i / 299.0);
  try {
    appliedOnly(A)->inverseOn(std::vector<char>(300, 1), 0.0)->solve(Vector(300, 1.0));
    FAIL();
  } catch (const NotConverged& failure) {
    EXPECT_THAT(failure.what(), testing::HasSubstr("conjugate gradients on the interface stopped"));
    EXPECT_THAT(failure.what(), testing::HasSubstr("use the condensed interface operator"));
  }
}

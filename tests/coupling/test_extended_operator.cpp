#include <gtest/gtest.h>

#include "interface/box_bodies.hpp"
#include "ndframe/interface/extended_operator.hpp"
#include "subdomain/sample_problems.hpp"

using namespace ndframe;
using namespace ndframe::test;

TEST(ExtendedOperator, StoredAndAppliedAreTheSameProduct)
{
  const DenseMatrix S = randomSpd(6, 1), R = rigidMotions(6, 2);
  const auto stored = extendOperator(makeDenseOperator(S), R), applied = extendOperator(appliedOnly(S), R);
  EXPECT_NE(stored->dense(), nullptr);
  EXPECT_EQ(applied->dense(), nullptr);
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Vector x = randomNumbers(8, seed), a = stored->apply(x), b = applied->apply(x);
    const Vector expected = extendedForces(multiply(S, extendedValues(x, R)), R);
    for (std::size_t i = 0; i < x.size(); ++i) {
      EXPECT_NEAR(a[i], expected[i], 1e-11);
      EXPECT_NEAR(b[i], expected[i], 1e-11);
    }
  }
}

TEST(ExtendedOperator, WithoutMotionsIsTheOperatorItself)
{
  const std::shared_ptr<const SymmetricOperator> S = makeDenseOperator(randomSpd(3, 1));
  EXPECT_EQ(extendOperator(S, DenseMatrix(3, 0)), S);
}

#include <gtest/gtest.h>

#include "interface/box_bodies.hpp"
#include "ndframe/interface/extended_operator.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

/// Symmetric and positive definite, without zeros.
DenseMatrix fullMatrix(int size)
{
  DenseMatrix S(size, size);
  for (int j = 0; j < size; ++j)
    for (int i = 0; i < size; ++i)
      S(i, j) = (i == j ? size : 0) + 1.0 / (1.0 + i + j);
  return S;
}

/// A translation and a rotation.
DenseMatrix motions(int size)
{
  DenseMatrix R(size, 2);
  for (int i = 0; i < size; ++i) {
    R(i, 0) = 1.0;
    R(i, 1) = 0.7 * i - 1.0;
  }
  return R;
}

} // namespace

TEST(ExtendedOperator, StoredAndAppliedAreTheSameProduct)
{
  const DenseMatrix S = fullMatrix(6), R = motions(6);
  const auto stored = extendOperator(makeDenseOperator(S), R), applied = extendOperator(appliedOnly(S), R);
  EXPECT_NE(stored->dense(), nullptr);
  EXPECT_EQ(applied->dense(), nullptr);
  for (int k = 0; k < 8; ++k) {
    Vector x(8, 0.3);
    x[std::size_t(k)] = -1.0;
    const Vector a = stored->apply(x), b = applied->apply(x);
    const Vector expected = extendedForces(multiply(S, extendedValues(x, R)), R);
    for (std::size_t i = 0; i < x.size(); ++i) {
      EXPECT_NEAR(a[i], expected[i], 1e-12);
      EXPECT_NEAR(b[i], expected[i], 1e-12);
    }
  }
}

TEST(ExtendedOperator, ValuesAndForcesDoTheSameWork)
{
  const DenseMatrix R = motions(4);
  const Vector unknowns = {0.1, -0.2, 0.3, 0.5, 2.0, -3.0}, force = {1.0, -4.0, 2.0, 0.5};
  EXPECT_NEAR(dot(extendedValues(unknowns, R), force), dot(unknowns, extendedForces(force, R)), 1e-14);
}

TEST(ExtendedOperator, WithoutMotionsIsTheOperatorItself)
{
  const std::shared_ptr<const SymmetricOperator> S = makeDenseOperator(fullMatrix(3));
  EXPECT_EQ(extendOperator(S, DenseMatrix(3, 0)), S);
}

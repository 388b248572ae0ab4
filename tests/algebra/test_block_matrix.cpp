#include <gtest/gtest.h>

#include "algebra/sample_bodies.hpp"
#include "common/test_main.hpp"

namespace ndframe
{

TEST(BlockMatrix, FindsTheBlocksOfItsPatternOnly)
{
  test::SampleBody body = test::trussBody({3, 2}, Comm::single());
  const BlockMatrix& K = body.matrix;
  EXPECT_NE(K.block(0, 1), nullptr);
  EXPECT_EQ(K.block(0, 2), nullptr);
  EXPECT_EQ(K.block(0, K.numNodes() - 1), nullptr);
  body.matrix.block(0, 1)[3] = 42.0;
  EXPECT_EQ(K.block(0, 1)[3], 42.0);
  EXPECT_EQ(K.block(0, 1), K.values.data() + 4);
}

TEST(BlockMatrix, DistributedProductAndDiagonalAreThoseOfTheWholeMatrix)
{
  const test::SampleBody own = test::trussBody({4, 3, 2}, test::comm()),
                         whole = test::trussBody({4, 3, 2}, Comm::single());
  const Vector x = test::randomVector(std::size_t(whole.matrix.numDofs()), 1);
  EXPECT_LT(test::relativeDifference(multiply(own.matrix, x, test::comm()), multiply(whole.matrix, x, Comm::single())),
            1e-14);
  EXPECT_EQ(diagonal(own.matrix, test::comm()), diagonal(whole.matrix, Comm::single()));
}

TEST(BlockMatrix, RigidMotionsNeedNoForce)
{
  const test::SampleBody body = test::trussBody({3, 2, 2}, test::comm());
  for (int m = 0; m < body.rigidMotions.cols(); ++m)
    EXPECT_LT(norm(multiply(body.matrix, body.rigidMotions.column(m), test::comm())), 1e-12);
}

TEST(BlockMatrix, ProductEqualsTheDenseProduct)
{
  const test::SampleBody body = test::trussBody({3, 3}, Comm::single());
  const DenseMatrix dense = test::DenseReference(body.problem(test::Support::Clamp)).full;
  const Vector x = test::randomVector(std::size_t(body.matrix.numDofs()), 2);
  EXPECT_LT(test::relativeDifference(multiply(body.matrix, x, Comm::single()), multiply(dense, x)), 1e-14);
}

} // namespace ndframe

#include <numeric>

#include <gtest/gtest.h>

#include "algebra/sample_bodies.hpp"
#include "common/test_main.hpp"
#include "ndframe/iterative/linear_level.hpp"

namespace ndframe
{

namespace
{

/// P, all dofs of both levels, as LinearInterpolation describes it.
DenseMatrix dense(const LinearInterpolation& P)
{
  const int dim = P.dim;
  DenseMatrix result(int(P.ends.size()) * dim, int(P.vertices.size()) * dim);
  for (int node = 0; node < int(P.ends.size()); ++node)
    for (int end = 0; end < 2; ++end)
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j) {
          const double* blocks = P.blocks(node);
          const double share = blocks ? blocks[(end * dim + i) * dim + j] : 0.5 * (i == j);
          result(node * dim + i, P.ends[std::size_t(node)][std::size_t(end)] * dim + j) += share;
        }
  return result;
}

DenseMatrix dense(const BlockMatrix& K)
{
  DenseMatrix result(K.numDofs(), K.numDofs());
  for (int r = 0; r < K.numRows(); ++r)
    for (auto b = K.rowPtr[std::size_t(r)]; b < K.rowPtr[std::size_t(r) + 1]; ++b)
      for (int i = 0; i < K.dim; ++i)
        for (int j = 0; j < K.dim; ++j)
          result(K.rowNode(r) * K.dim + i, K.colNode(b) * K.dim + j) =
              K.values[std::size_t((b * K.dim + i) * K.dim + j)];
  return result;
}

/// Every third row and column that the roles do not call interior is zero.
DenseMatrix masked(DenseMatrix A, const std::vector<DofRole>& roles)
{
  for (int j = 0; j < A.cols(); ++j)
    for (int i = 0; i < A.rows(); ++i)
      if (roles[std::size_t(i)] != DofRole::Interior || roles[std::size_t(j)] != DofRole::Interior)
        A(i, j) = 0.0;
  return A;
}

class LinearLevelTest : public testing::TestWithParam<std::vector<int>>
{
protected:
  LinearLevelTest()
      : body(test::trussBody(GetParam(), test::comm())), whole(test::trussBody(GetParam(), Comm::single())),
        problem(body.problem(test::Support::Guide)), wholeProblem(whole.problem(test::Support::Guide))
  {
    std::vector<int> chosen;
    for (int node = 0; node < body.matrix.numNodes(); node += 3)
      chosen.push_back(node);
    test::turnNodes(body, problem, chosen);
    test::turnNodes(whole, wholeProblem, chosen);
  }

  test::SampleBody body, whole;
  SolverProblem problem, wholeProblem;
};

} // namespace

TEST_P(LinearLevelTest, HasTheMatrixOfTheInteriorDofsInTheSpaceOfLinearFunctions)
{
  const LinearLevel level(problem, test::comm());
  const DenseMatrix P = dense(level.interpolation), K = masked(dense(whole.matrix), problem.roles);
  const DenseMatrix expected = masked(multiplyTransposed(P, multiply(K, P)), level.problem.roles);
  DenseMatrix found = masked(dense(level.matrix), level.problem.roles);
  Vector values(found.data(), found.data() + std::size_t(found.rows()) * std::size_t(found.cols()));
  test::comm().sum(values);
  const Vector wanted(expected.data(), expected.data() + values.size());
  EXPECT_LT(test::relativeDifference(values, wanted), 1e-14);
}

/// Rigid motions are linear: their values at the vertices interpolate to those at all nodes, in all nodes' own axes.
TEST_P(LinearLevelTest, InterpolatesRigidMotions)
{
  const LinearLevel level(problem, test::comm());
  const DenseMatrix& own = level.problem.nearNullSpace;
  ASSERT_EQ(own.rows(), level.matrix.numRows() * level.matrix.dim);
  DenseMatrix vertices(level.matrix.numDofs(), own.cols());
  for (int m = 0; m < own.cols(); ++m) {
    Vector all(std::size_t(vertices.rows()), 0.0);
    for (int i = 0; i < own.rows(); ++i)
      all[std::size_t(level.matrix.rowNode(i / level.matrix.dim) * level.matrix.dim + i % level.matrix.dim)] =
          own(i, m);
    test::comm().sum(all);
    std::copy(all.begin(), all.end(), vertices.col(m));
  }
  const DenseMatrix motions = multiply(dense(level.interpolation), vertices);
  EXPECT_LT(test::relativeDifference(motions, problem.nearNullSpace), 1e-14);
}

TEST_P(LinearLevelTest, SharesOutItsRowsAsTheNodesAre)
{
  const LinearLevel level(problem, test::comm());
  Vector owners(level.interpolation.vertices.size(), 0.0);
  for (int row = 0; row < level.matrix.numRows(); ++row)
    owners[std::size_t(level.matrix.rowNode(row))] += 1.0;
  test::comm().sum(owners);
  EXPECT_EQ(owners, Vector(owners.size(), 1.0));
  EXPECT_EQ(int(level.problem.nodePoints.size()), level.matrix.numRows() * level.matrix.dim);
  EXPECT_EQ(int(level.problem.roles.size()), level.matrix.numDofs());
}

INSTANTIATE_TEST_SUITE_P(Bodies, LinearLevelTest, testing::Values(std::vector{6, 4}, std::vector{4, 2, 2}),
                         [](const auto& cells) { return cells.param.size() == 2 ? "In2D" : "In3D"; });

} // namespace ndframe

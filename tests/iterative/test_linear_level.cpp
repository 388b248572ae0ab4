#include <numeric>

#include <gtest/gtest.h>

#include "algebra/sample_bodies.hpp"
#include "common/test_main.hpp"
#include "ndframe/iterative/linear_level.hpp"
#include "rank_problem.hpp"

namespace ndframe
{

namespace
{

DenseMatrix summed(DenseMatrix own)
{
  Vector values(own.data(), own.data() + std::size_t(own.rows()) * std::size_t(own.cols()));
  test::comm().sum(values);
  std::copy(values.begin(), values.end(), own.data());
  return own;
}

/// P, all dofs of both levels and of all ranks, as LinearInterpolation describes it; columns by the vertices' nodes.
DenseMatrix dense(const LinearInterpolation& P, const BlockMatrix& K)
{
  const int dim = P.dim;
  DenseMatrix result(K.numDofs(), int(P.vertices.globalSize()) * dim);
  for (int node = 0; node < int(P.ends.size()); ++node)
    for (int end = 0; end < 2; ++end)
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j) {
          const double* blocks = P.blocks(node);
          const double share = blocks ? blocks[(end * dim + i) * dim + j] : 0.5 * (i == j);
          const int vertex = int(P.vertices.global(P.ends[std::size_t(node)][std::size_t(end)]));
          result(K.rowNode(node) * dim + i, vertex * dim + j) += share;
        }
  return summed(std::move(result));
}

/// Per dof of all ranks whether its owner says that it is interior.
std::vector<DofRole> rolesOfAll(const RankProblem& problem)
{
  const BlockMatrix& K = *problem.matrix;
  Vector isInterior(std::size_t(K.numDofs()), 0.0);
  for (int r = 0; r < K.numRows(); ++r)
    for (int i = 0; i < K.dim; ++i)
      isInterior[std::size_t(K.rowNode(r) * K.dim + i)] = problem.role(r, i) == DofRole::Interior;
  test::comm().sum(isInterior);
  std::vector<DofRole> roles;
  for (const double value : isInterior)
    roles.push_back(value > 0.0 ? DofRole::Interior : DofRole::Fixed);
  return roles;
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

  RankProblem held() const { return heldPart(problem, true); }

  test::SampleBody body, whole;
  SolverProblem problem, wholeProblem;
};

} // namespace

TEST_P(LinearLevelTest, HasTheMatrixOfTheInteriorDofsInTheSpaceOfLinearFunctions)
{
  const RankProblem fine = held();
  const LinearLevel level(fine, test::comm());
  const std::vector<DofRole> roles = rolesOfAll(level.problem);
  const DenseMatrix P = dense(level.interpolation, body.matrix), K = masked(dense(whole.matrix), problem.roles);
  const DenseMatrix expected = masked(multiplyTransposed(P, multiply(K, P)), roles);
  EXPECT_LT(test::relativeDifference(summed(masked(dense(level.matrix), roles)), expected), 1e-14);
}

/// Rigid motions are linear: their values at the vertices interpolate to those at all nodes, in all nodes' own axes.
TEST_P(LinearLevelTest, InterpolatesRigidMotions)
{
  const RankProblem fine = held();
  const LinearLevel level(fine, test::comm());
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
  const DenseMatrix motions = multiply(dense(level.interpolation, body.matrix), vertices);
  EXPECT_LT(test::relativeDifference(motions, problem.nearNullSpace), 1e-14);
}

TEST_P(LinearLevelTest, SharesOutItsRowsAsTheNodesAre)
{
  const RankProblem fine = held();
  const LinearLevel level(fine, test::comm());
  Vector owners(std::size_t(level.matrix.numNodes()), 0.0), expected(owners);
  for (int row = 0; row < level.matrix.numRows(); ++row)
    owners[std::size_t(level.matrix.rowNode(row))] += 1.0;
  test::comm().sum(owners);
  for (std::size_t node = 0; node < expected.size(); ++node)
    expected[node] = problem.edgeNodes.ends[node][0] == problem.edgeNodes.ends[node][1];
  EXPECT_EQ(owners, expected);
  EXPECT_EQ(int(level.problem.nodePoints.size()), level.matrix.numRows() * level.matrix.dim);
  EXPECT_EQ(int(level.problem.roles.size()), level.matrix.nodes.size() * level.matrix.dim);
}

/// Where rows have columns of other ranks, these are what their owners say.
TEST_P(LinearLevelTest, KnowsTheRolesOfItsGhosts)
{
  const RankProblem fine = held();
  const LinearLevel level(fine, test::comm());
  const std::vector<DofRole> roles = rolesOfAll(level.problem);
  const int dim = level.matrix.dim;
  for (int node = 0; node < level.matrix.nodes.size(); ++node)
    for (int i = 0; i < dim; ++i)
      EXPECT_EQ(level.problem.role(node, i), roles[std::size_t(level.matrix.nodes.global(node) * dim + i)]);
}

INSTANTIATE_TEST_SUITE_P(Bodies, LinearLevelTest, testing::Values(std::vector{6, 4}, std::vector{4, 2, 2}),
                         [](const auto& cells) { return cells.param.size() == 2 ? "In2D" : "In3D"; });

} // namespace ndframe

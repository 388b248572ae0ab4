#include "stored_problem.hpp"

#include <utility>

#include "ndframe/iterative/linear_level.hpp"

namespace ndframe
{

namespace
{

/// u = P c
void interpolate(const LinearInterpolation& P, const double* vertices, double* nodes)
{
  const auto dim = std::size_t(P.dim);
  for (std::size_t node = 0; node < P.ends.size(); ++node)
    for (std::size_t i = 0; i < dim; ++i) {
      double& value = nodes[node * dim + i] = 0.0;
      const double* blocks = P.blocks(int(node));
      for (std::size_t end = 0; end < 2; ++end) {
        const double* given = vertices + std::size_t(P.ends[node][end]) * dim;
        if (!blocks)
          value += 0.5 * given[i];
        else
          for (std::size_t k = 0; k < dim; ++k)
            value += blocks[(end * dim + i) * dim + k] * given[k];
      }
    }
}

} // namespace

SolverProblem withVerticesOnly(const SolverProblem& given)
{
  if (given.edgeNodes.ends.empty())
    return given;
  SolverProblem problem{given.matrix, given.roles, given.kept, {}, {}, given.edgeNodes, given.outline};
  const int dim = given.matrix->dim;
  std::vector<int> dofs;
  for (std::size_t node = 0; node < given.edgeNodes.ends.size(); ++node)
    if (given.edgeNodes.ends[node][0] == given.edgeNodes.ends[node][1])
      for (int i = 0; i < dim; ++i)
        dofs.push_back(int(node) * dim + i);
  const int modes = given.nearNullSpace.cols();
  problem.nearNullSpace = DenseMatrix(modes == 0 ? 0 : int(dofs.size()), modes);
  for (int m = 0; m < modes; ++m)
    for (int i = 0; i < problem.nearNullSpace.rows(); ++i)
      problem.nearNullSpace(i, m) = given.nearNullSpace(dofs[std::size_t(i)], m);
  for (std::size_t i = 0; i < dofs.size() && !given.nodePoints.empty(); ++i)
    problem.nodePoints.push_back(given.nodePoints[std::size_t(dofs[i])]);
  return problem;
}

SolverProblem withAllNodes(SolverProblem problem)
{
  if (problem.edgeNodes.ends.empty())
    return problem;
  const int dim = problem.matrix->dim, numDofs = problem.matrix->numDofs();
  const DenseMatrix modes = std::exchange(problem.nearNullSpace, {});
  const std::vector<double> points = std::exchange(problem.nodePoints, {});
  const LinearInterpolation inOwnAxes(problem.edgeNodes, dim);
  problem.nearNullSpace = DenseMatrix(modes.cols() == 0 ? 0 : numDofs, modes.cols());
  for (int m = 0; m < modes.cols(); ++m)
    interpolate(inOwnAxes, modes.col(m), problem.nearNullSpace.col(m));
  if (points.empty())
    return problem;
  problem.nodePoints.resize(std::size_t(numDofs));
  interpolate(LinearInterpolation({problem.edgeNodes.ends, {}, {}}, dim), points.data(), problem.nodePoints.data());
  return problem;
}

} // namespace ndframe

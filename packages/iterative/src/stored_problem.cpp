#include "stored_problem.hpp"

#include <algorithm>
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

/// The dofs of the vertices among this rank's nodes.
std::vector<int> ownVertexDofs(const SolverProblem& problem)
{
  const BlockMatrix& K = *problem.matrix;
  std::vector<int> dofs;
  for (int r = 0; r < K.numRows(); ++r)
    if (const auto& ends = problem.edgeNodes.ends[std::size_t(K.rowNode(r))]; ends[0] == ends[1])
      for (int i = 0; i < K.dim; ++i)
        dofs.push_back(K.rowNode(r) * K.dim + i);
  return dofs;
}

/// Values at the vertices of all ranks from those of each, at the middles of edges zero. Collective.
Vector atVertices(const SolverProblem& problem, const double* own, const Comm& comm)
{
  Vector all(std::size_t(problem.matrix->numDofs()), 0.0);
  for (const int dof : ownVertexDofs(problem))
    all[std::size_t(dof)] = *own++;
  comm.sum(all);
  return all;
}

/// The same with what is linear along the edges.
Vector atAllNodes(const SolverProblem& problem, const LinearInterpolation& P, const double* own, const Comm& comm)
{
  const Vector given = atVertices(problem, own, comm);
  Vector vertices, nodes(given.size());
  for (const int node : P.vertices)
    vertices.insert(vertices.end(), given.begin() + std::ptrdiff_t(node) * P.dim,
                    given.begin() + std::ptrdiff_t(node + 1) * P.dim);
  interpolate(P, vertices.data(), nodes.data());
  return nodes;
}

} // namespace

SolverProblem withOwnVertices(const SolverProblem& given)
{
  if (given.edgeNodes.ends.empty())
    return given;
  SolverProblem problem{given.matrix, given.roles, given.kept, {}, {}, given.edgeNodes, given.outline};
  const std::vector<int> dofs = ownVertexDofs(given);
  const int modes = given.nearNullSpace.cols();
  problem.nearNullSpace = DenseMatrix(modes == 0 ? 0 : int(dofs.size()), modes);
  for (int m = 0; m < modes; ++m)
    for (int i = 0; i < problem.nearNullSpace.rows(); ++i)
      problem.nearNullSpace(i, m) = given.nearNullSpace(dofs[std::size_t(i)], m);
  for (std::size_t i = 0; i < dofs.size() && !given.nodePoints.empty(); ++i)
    problem.nodePoints.push_back(given.nodePoints[std::size_t(dofs[i])]);
  return problem;
}

SolverProblem withAllNodes(SolverProblem problem, const Comm& comm)
{
  if (problem.edgeNodes.ends.empty())
    return problem;
  const int dim = problem.matrix->dim, numDofs = problem.matrix->numDofs();
  const DenseMatrix modes = std::exchange(problem.nearNullSpace, {});
  const std::vector<double> points = std::exchange(problem.nodePoints, {});
  const LinearInterpolation inOwnAxes(problem.edgeNodes, dim);
  problem.nearNullSpace = DenseMatrix(modes.cols() == 0 ? 0 : numDofs, modes.cols());
  for (int m = 0; m < modes.cols(); ++m) {
    const Vector mode = atAllNodes(problem, inOwnAxes, modes.col(m), comm);
    std::copy(mode.begin(), mode.end(), problem.nearNullSpace.col(m));
  }
  Vector numPoints{double(points.size())};
  comm.sum(numPoints); // a rank may have no vertices
  if (numPoints.front() > 0.0)
    problem.nodePoints =
        atAllNodes(problem, LinearInterpolation({problem.edgeNodes.ends, {}, {}}, dim), points.data(), comm);
  return problem;
}

} // namespace ndframe

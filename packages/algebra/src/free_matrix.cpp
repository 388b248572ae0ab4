#include "free_matrix.hpp"

#include <limits>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

double meanKeptDiagonal(const SolverProblem& problem, const Comm& comm)
{
  if (problem.kept.empty())
    return 0.0;
  const Vector d = diagonal(*problem.matrix, comm);
  double sum = 0.0;
  for (const int dof : problem.kept)
    sum += d[std::size_t(dof)];
  return sum / double(problem.kept.size());
}

void shiftKept(UpperTriangle& A, const SolverProblem& problem, const FreeDofs& free, const Vector& shift)
{
  for (std::size_t c = 0; c < shift.size(); ++c)
    A.diagonal(free.number[std::size_t(problem.kept[c])]) += shift[c];
}

UpperTriangle freeUpperTriangle(const SolverProblem& problem, const FreeDofs& free)
{
  const BlockMatrix& K = *problem.matrix;
  UpperTriangle A;
  const std::size_t upperBound = (std::size_t(K.numBlocks()) * K.dim * K.dim + free.dofs.size()) / 2;
  A.colPtr.reserve(free.dofs.size() + 1);
  A.rows.reserve(upperBound);
  A.values.reserve(upperBound);
  A.colPtr.push_back(0);
  for (const int dof : free.dofs) {
    // Column `dof` of the upper triangle is, by symmetry, the beginning of row `dof`.
    const int node = dof / K.dim, component = dof % K.dim;
    for (std::int64_t b = K.rowPtr[std::size_t(node)]; b < K.rowPtr[std::size_t(node) + 1]; ++b)
      for (int j = 0, other = K.colNode(b) * K.dim; j < K.dim && other <= dof; ++j, ++other) {
        if (free.number[std::size_t(other)] < 0)
          continue;
        A.rows.push_back(free.number[std::size_t(other)]);
        A.values.push_back(
            K.values[(std::size_t(b) * std::size_t(K.dim) + std::size_t(component)) * std::size_t(K.dim) +
                     std::size_t(j)]);
      }
    NDFRAME_ASSERT(!A.rows.empty() && A.rows.back() == free.number[std::size_t(dof)], "a row has no diagonal entry");
    NDFRAME_ASSERT(A.rows.size() <= std::size_t(std::numeric_limits<int>::max()),
                   "the matrix is too large for Cholmod");
    A.colPtr.push_back(int(A.rows.size()));
  }
  return A;
}

} // namespace ndframe

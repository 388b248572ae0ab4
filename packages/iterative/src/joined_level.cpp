#include "joined_level.hpp"

#include <algorithm>

#include "block_row_sum.hpp"
#include "ndframe/algebra/shared_rows.hpp"

namespace ndframe
{

namespace
{

/// Which dofs stand for others.
class Followers
{
public:
  Followers(const std::vector<int>& keptDofs, const JoinedRows& rows, int numDofs)
      : keptDofs_(keptDofs), rows_(rows), keptOf_(std::size_t(numDofs), -1)
  {
    for (std::size_t k = 0; k < keptDofs.size(); ++k)
      if (keptDofs[k] >= 0)
        keptOf_[std::size_t(keptDofs[k])] = int(k);
  }

  bool isKept(int dof) const { return keptOf_[std::size_t(dof)] >= 0; }
  /// Whether a kept dof is the place of an unknown.
  bool isUnknown(int dof) const { return !rows_.unknowns[std::size_t(keptOf_[std::size_t(dof)])].empty(); }
  /// take(place, share) for all unknowns that a dof follows; any other dof is its own.
  template <class Take>
  void each(int dof, const Take& take) const
  {
    const int kept = keptOf_[std::size_t(dof)];
    if (kept < 0)
      return take(dof, 1.0);
    for (const auto& [place, share] : rows_.kept[std::size_t(kept)])
      take(keptDofs_[std::size_t(place)], share);
  }

private:
  const std::vector<int>& keptDofs_;
  const JoinedRows& rows_;
  std::vector<int> keptOf_; ///< per dof
};

/// Rows of E^T K E.
class FollowingProduct
{
public:
  FollowingProduct(const Followers& followers, int dim, int numNodes)
      : followers_(followers), dim_(dim), sum_(dim, numNodes), parts_(std::size_t(numNodes))
  {}

  /// Takes part with its rows, which must stay where they are.
  void add(const BlockMatrix& rows)
  {
    for (int r = 0; r < rows.numRows(); ++r)
      for (int i = 0; i < dim_; ++i)
        followers_.each(rows.rowNode(r) * dim_ + i, [&](int place, double share) {
          parts_[std::size_t(place / dim_)].push_back({&rows, r, i, place % dim_, share});
        });
  }

  BlockMatrix rowsOf(const std::vector<int>& nodes) &&
  {
    for (const int node : nodes) {
      sum_.block(node); // what is left of a row may be nothing
      for (const Part& part : parts_[std::size_t(node)])
        addPart(part);
      sum_.end(node);
    }
    return std::move(sum_).take();
  }

private:
  /// Row `component` of a block row, which counts in row `target` of the node.
  struct Part
  {
    const BlockMatrix* rows;
    int row, component, target;
    double share;
  };

  void addPart(const Part& part)
  {
    const BlockMatrix& K = *part.rows;
    for (std::int64_t b = K.rowPtr[std::size_t(part.row)]; b < K.rowPtr[std::size_t(part.row) + 1]; ++b) {
      const double* row = K.values.data() + (b * dim_ + part.component) * dim_;
      for (int j = 0; j < dim_; ++j)
        followers_.each(K.colNode(b) * dim_ + j, [&](int place, double share) {
          sum_.block(place / dim_)[part.target * dim_ + place % dim_] += part.share * share * row[j];
        });
    }
  }

  const Followers& followers_;
  int dim_;
  BlockRowSum sum_;
  std::vector<std::vector<Part>> parts_; ///< per node
};

/// The place of a dof of all among those of this rank's rows; -1: another rank's, or none.
int ownDof(const BlockMatrix& matrix, int dof)
{
  const int row = dof < 0 ? -1 : matrix.rowOf(dof / matrix.dim);
  return row < 0 ? -1 : row * matrix.dim + dof % matrix.dim;
}

BlockMatrix followingMatrix(const BlockMatrix& K, const Followers& followers, const Comm& comm)
{
  const auto placesOf = [&](int node) {
    std::vector<int> nodes;
    for (int i = 0; i < K.dim; ++i)
      followers.each(node * K.dim + i, [&](int place, double) { nodes.push_back(place / K.dim); });
    return nodes;
  };
  const BlockMatrix received = receivedRows(K, placesOf, comm);
  FollowingProduct product(followers, K.dim, K.numNodes());
  product.add(K);
  product.add(received);
  std::vector<int> own;
  for (int r = 0; r < K.numRows(); ++r)
    own.push_back(K.rowNode(r));
  return std::move(product).rowsOf(own);
}

/// The bodies' matrices as blocks of one.
BlockMatrix stacked(const std::vector<std::unique_ptr<LinearLevel>>& levels)
{
  std::vector<const IndexMap*> maps;
  for (const auto& level : levels)
    maps.push_back(&level->matrix.nodes);
  BlockMatrix result{levels.front()->matrix.dim, ndframe::stacked(maps), {0}, {}, {}};
  int owned = 0, ghosts = result.numRows();
  for (const auto& level : levels) {
    const BlockMatrix& matrix = level->matrix;
    for (const int column : matrix.cols)
      result.cols.push_back(matrix.nodes.owns(column) ? owned + column : ghosts + column - matrix.numRows());
    const std::int64_t before = result.rowPtr.back();
    for (std::size_t r = 1; r < matrix.rowPtr.size(); ++r)
      result.rowPtr.push_back(before + matrix.rowPtr[r]);
    result.values.insert(result.values.end(), matrix.values.begin(), matrix.values.end());
    owned += matrix.numRows();
    ghosts += matrix.nodes.size() - matrix.numRows();
  }
  return result;
}

/// At kept dofs of all ranks. own: a column at own dofs.
Vector atKept(const BlockMatrix& matrix, const std::vector<int>& keptDofs, const double* own, const Comm& comm)
{
  Vector result(keptDofs.size(), 0.0);
  for (std::size_t k = 0; k < keptDofs.size(); ++k)
    if (const int dof = ownDof(matrix, keptDofs[k]); dof >= 0)
      result[k] = own[dof];
  comm.sum(result);
  return result;
}

/// The bodies' modes side by side, at own dofs; those of an unknown are its own.
DenseMatrix stackedModes(const std::vector<std::unique_ptr<LinearLevel>>& levels, const BlockMatrix& matrix,
                         const std::vector<int>& keptDofs, const JoinedRows& rows, const Comm& comm)
{
  int modes = levels.front()->problem.nearNullSpace.cols();
  for (const auto& level : levels)
    modes = std::min(modes, level->problem.nearNullSpace.cols());
  DenseMatrix result(modes == 0 ? 0 : matrix.numRows() * matrix.dim, modes);
  for (int m = 0; m < modes; ++m) {
    double* next = result.col(m);
    for (const auto& level : levels)
      next = std::copy_n(level->problem.nearNullSpace.col(m), level->problem.nearNullSpace.rows(), next);
    const Vector given = atKept(matrix, keptDofs, result.col(m), comm);
    for (std::size_t k = 0; k < keptDofs.size(); ++k) {
      const int dof = ownDof(matrix, keptDofs[k]);
      if (dof < 0)
        continue;
      result(dof, m) = 0.0;
      for (const auto& [other, share] : rows.unknowns[k])
        result(dof, m) += share * given[std::size_t(other)];
    }
  }
  return result;
}

void addSprings(BlockMatrix& matrix, const std::vector<int>& keptDofs, const Vector& springs)
{
  for (std::size_t k = 0; k < springs.size(); ++k) {
    const int dof = springs[k] == 0.0 ? -1 : ownDof(matrix, keptDofs[k]), row = dof / matrix.dim;
    if (dof >= 0)
      matrix.block(row, row)[std::ptrdiff_t(dof % matrix.dim) * (matrix.dim + 1)] += springs[k];
  }
}

} // namespace

JoinedLevel::JoinedLevel(const std::vector<std::unique_ptr<LinearLevel>>& levels, const std::vector<int>& keptDofs,
                         const JoinedRows& rows, const Vector& springs, const Comm& comm)
{
  for (const auto& level : levels) {
    problem.roles.insert(problem.roles.end(), level->problem.roles.begin(), level->problem.roles.end());
    problem.nodePoints.insert(problem.nodePoints.end(), level->problem.nodePoints.begin(),
                              level->problem.nodePoints.end());
  }
  const int numDofs = int(problem.roles.size());
  const Followers followers(keptDofs, rows, numDofs);
  for (int dof = 0; dof < numDofs; ++dof)
    if (followers.isKept(dof) && !followers.isUnknown(dof))
      problem.roles[std::size_t(dof)] = DofRole::Fixed;
  matrix = followingMatrix(stacked(levels), followers, comm);
  problem.nearNullSpace = stackedModes(levels, matrix, keptDofs, rows, comm);
  addSprings(matrix, keptDofs, springs);
  problem.matrix = &matrix;
}

} // namespace ndframe

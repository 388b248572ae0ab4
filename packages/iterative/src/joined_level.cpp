#include "joined_level.hpp"

#include <algorithm>
#include <optional>

#include "block_row_sum.hpp"
#include "held_roles.hpp"
#include "ndframe/algebra/shared_rows.hpp"

namespace ndframe
{

namespace
{

using Global = IndexMap::Global;

/// Which kept dof of all is each dof that this rank holds, -1: none.
std::vector<int> keptOf(const std::vector<Global>& keptDofs, const IndexMap& nodes, int dim)
{
  std::vector<int> result(std::size_t(nodes.size()) * std::size_t(dim), -1);
  for (std::size_t k = 0; k < keptDofs.size(); ++k) {
    const int node = keptDofs[k] < 0 ? -1 : nodes.local(keptDofs[k] / dim);
    if (node >= 0)
      result[std::size_t(node) * std::size_t(dim) + std::size_t(keptDofs[k] % dim)] = int(k);
  }
  return result;
}

/// The rows of E^T K E of own nodes.
class FollowingProduct
{
public:
  FollowingProduct(const std::vector<Global>& keptDofs, const JoinedRows& rows, const BlockMatrix& K,
                   const BlockMatrix& received)
      : dim_(K.dim), rows_(rows)
  {
    for (const BlockMatrix* matrix : {&K, &received})
      matrices_.push_back({matrix, keptOf(keptDofs, matrix->nodes, dim_), {}});
    const IndexMap nodes = nodesOf(keptDofs);
    for (Matrix& matrix : matrices_)
      for (int node = 0; node < matrix.rows->nodes.size(); ++node)
        matrix.numbers.push_back(nodes.local(matrix.rows->nodes.global(node)));
    for (const Global dof : keptDofs) {
      const int node = dof < 0 ? -1 : nodes.local(dof / dim_);
      places_.push_back(node < 0 ? -1 : node * dim_ + int(dof % dim_));
    }
    sum_.emplace(dim_, nodes);
    parts_.resize(std::size_t(nodes.numOwned()));
    for (const Matrix& matrix : matrices_)
      add(matrix);
  }

  BlockMatrix product() &&
  {
    for (std::size_t node = 0; node < parts_.size(); ++node) {
      sum_->block(int(node)); // what is left of a row may be nothing
      for (const Part& part : parts_[node])
        addPart(part);
      sum_->end();
    }
    return std::move(*sum_).take();
  }

private:
  /// Rows, and per dof and node that they hold which kept dof it is and its number here.
  struct Matrix
  {
    const BlockMatrix* rows;
    std::vector<int> kept, numbers;
  };
  /// Row `component` of a block row, which counts in row `target` of the node.
  struct Part
  {
    const Matrix* matrix;
    int row, component, target;
    double share;
  };

  /// What the rows hold, and the places of what their kept dofs follow.
  IndexMap nodesOf(const std::vector<Global>& keptDofs) const
  {
    const IndexMap& own = matrices_.front().rows->nodes;
    if (own.isWhole())
      return own;
    std::vector<Global> owned, needed;
    for (const Matrix& matrix : matrices_) {
      const IndexMap& nodes = matrix.rows->nodes;
      for (int node = 0; node < nodes.size(); ++node)
        (&nodes == &own && own.owns(node) ? owned : needed).push_back(nodes.global(node));
      for (const int kept : matrix.kept)
        for (std::size_t f = 0; kept >= 0 && f < rows_.kept[std::size_t(kept)].size(); ++f)
          needed.push_back(keptDofs[std::size_t(rows_.kept[std::size_t(kept)][f].first)] / dim_);
    }
    return {own.globalSize(), std::move(owned), std::move(needed)};
  }

  /// take(place, share) for all unknowns that a dof follows; any other dof is its own.
  template <class Take>
  void each(const Matrix& matrix, int node, int component, const Take& take) const
  {
    const int kept = matrix.kept[std::size_t(node) * std::size_t(dim_) + std::size_t(component)];
    if (kept < 0)
      return take(matrix.numbers[std::size_t(node)] * dim_ + component, 1.0);
    for (const auto& [place, share] : rows_.kept[std::size_t(kept)])
      take(places_[std::size_t(place)], share);
  }

  void add(const Matrix& matrix)
  {
    for (int r = 0; r < matrix.rows->numRows(); ++r)
      for (int i = 0; i < dim_; ++i)
        each(matrix, r, i, [&](int place, double share) {
          if (place / dim_ < int(parts_.size()))
            parts_[std::size_t(place / dim_)].push_back({&matrix, r, i, place % dim_, share});
        });
  }

  void addPart(const Part& part)
  {
    const BlockMatrix& K = *part.matrix->rows;
    for (std::int64_t b = K.rowPtr[std::size_t(part.row)]; b < K.rowPtr[std::size_t(part.row) + 1]; ++b) {
      const double* row = K.values.data() + (b * dim_ + part.component) * dim_;
      for (int j = 0; j < dim_; ++j)
        each(*part.matrix, K.cols[std::size_t(b)], j, [&](int place, double share) {
          sum_->block(place / dim_)[part.target * dim_ + place % dim_] += part.share * share * row[j];
        });
    }
  }

  int dim_;
  const JoinedRows& rows_;
  std::vector<Matrix> matrices_;
  std::vector<int> places_; ///< per kept dof that dof here, -1: none
  std::optional<BlockRowSum> sum_;
  std::vector<std::vector<Part>> parts_; ///< per own node
};

/// The place of a dof of all among those of this rank's rows; -1: another rank's, or none.
int ownDof(const BlockMatrix& matrix, Global dof)
{
  const int row = dof < 0 ? -1 : matrix.rowOf(dof / matrix.dim);
  return row < 0 ? -1 : row * matrix.dim + int(dof % matrix.dim);
}

BlockMatrix followingMatrix(const BlockMatrix& K, const std::vector<Global>& keptDofs,
                            const std::vector<int>& keptOfOwn, const JoinedRows& rows, const Comm& comm)
{
  const auto placesOf = [&](int row) {
    std::vector<Global> nodes;
    for (int dof = row * K.dim; dof < (row + 1) * K.dim; ++dof)
      if (const int kept = keptOfOwn[std::size_t(dof)]; kept >= 0)
        for (const auto& [place, share] : rows.kept[std::size_t(kept)])
          nodes.push_back(keptDofs[std::size_t(place)] / K.dim);
    return nodes;
  };
  const BlockMatrix received = receivedRows(K, placesOf, comm);
  return FollowingProduct(keptDofs, rows, K, received).product();
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
Vector atKept(const BlockMatrix& matrix, const std::vector<Global>& keptDofs, const double* own, const Comm& comm)
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
                         const std::vector<Global>& keptDofs, const JoinedRows& rows, const Comm& comm)
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

void addSprings(BlockMatrix& matrix, const std::vector<Global>& keptDofs, const Vector& springs)
{
  for (std::size_t k = 0; k < springs.size(); ++k) {
    const int dof = springs[k] == 0.0 ? -1 : ownDof(matrix, keptDofs[k]), row = dof / matrix.dim;
    if (dof >= 0)
      matrix.block(row, row)[std::ptrdiff_t(dof % matrix.dim) * (matrix.dim + 1)] += springs[k];
  }
}

} // namespace

JoinedLevel::JoinedLevel(const std::vector<std::unique_ptr<LinearLevel>>& levels, const std::vector<Global>& keptDofs,
                         const JoinedRows& rows, const Vector& springs, const Comm& comm)
{
  std::vector<char> isInterior; // per own dof
  for (const auto& level : levels) {
    const auto numOwn = std::ptrdiff_t(level->matrix.numRows()) * level->matrix.dim;
    for (std::ptrdiff_t dof = 0; dof < numOwn; ++dof)
      isInterior.push_back(level->problem.roles[std::size_t(dof)] == DofRole::Interior);
    problem.nodePoints.insert(problem.nodePoints.end(), level->problem.nodePoints.begin(),
                              level->problem.nodePoints.end());
  }
  const BlockMatrix K = stacked(levels);
  const std::vector<int> kept = keptOf(keptDofs, K.nodes, K.dim);
  for (std::size_t dof = 0; dof < isInterior.size(); ++dof)
    if (kept[dof] >= 0 && rows.unknowns[std::size_t(kept[dof])].empty())
      isInterior[dof] = 0;
  matrix = followingMatrix(K, keptDofs, kept, rows, comm);
  problem.roles = heldRoles(matrix.nodes, matrix.dim, isInterior, comm);
  problem.nearNullSpace = stackedModes(levels, matrix, keptDofs, rows, comm);
  addSprings(matrix, keptDofs, springs);
  problem.matrix = &matrix;
}

} // namespace ndframe

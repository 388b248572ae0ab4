#include "ndframe/iterative/linear_level.hpp"

#include <algorithm>

#include "block_row_sum.hpp"
#include "held_roles.hpp"
#include "ndframe/algebra/shared_rows.hpp"
#include "product_nodes.hpp"

namespace ndframe
{

namespace
{

using Global = IndexMap::Global;

/// Q_m Q_a^T / 2, row-major; null axes are x, y, z.
void addTurnedHalf(const double* middle, const double* end, int dim, std::vector<double>& blocks)
{
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j) {
      double cosine = 0.0;
      for (int k = 0; k < dim; ++k)
        cosine += (middle ? middle[i * dim + k] : double(i == k)) * (end ? end[j * dim + k] : double(j == k));
      blocks.push_back(0.5 * cosine);
    }
}

struct Block
{
  double values[9];
};

/// Part of a product: the rows of P^T K P that belong to own vertices.
class GalerkinProduct
{
public:
  GalerkinProduct(int dim, const ProductNodes& nodes)
      : nodes_(nodes), dim_(dim), children_(std::size_t(nodes.vertices().numOwned())), sum_(dim, nodes.vertices())
  {}

  /// Takes part with its rows, which must stay where they are.
  void add(const BlockMatrix& rows)
  {
    matrices_.push_back(&rows);
    numbers_.emplace_back();
    for (int node = 0; node < rows.nodes.size(); ++node)
      numbers_.back().push_back(nodes_.nodes().local(rows.nodes.global(node)));
    for (int r = 0; r < rows.numRows(); ++r) {
      const auto& [a, b] = nodes_.ends(numbers_.back()[std::size_t(r)]);
      addChild(a, r);
      if (a != b)
        addChild(b, r);
    }
  }

  BlockMatrix product() &&
  {
    for (int vertex = 0; vertex < int(children_.size()); ++vertex) {
      for (const Child& child : children_[std::size_t(vertex)])
        addProduct(std::size_t(child.matrix), child.row, vertex);
      sum_.end();
    }
    return std::move(sum_).take();
  }

private:
  /// A row of one of the matrices.
  struct Child
  {
    int matrix, row;
  };

  void addChild(int vertex, int r)
  {
    if (nodes_.vertices().owns(vertex))
      children_[std::size_t(vertex)].push_back({int(matrices_.size()) - 1, r});
  }

  /// Adds (P^T)_vertex,i K_ij P_jq for all j and q.
  void addProduct(std::size_t matrix, int r, int vertex)
  {
    const BlockMatrix& K = *matrices_[matrix];
    const std::vector<int>& numbers = numbers_[matrix];
    const int node = numbers[std::size_t(r)], size = dim_ * dim_;
    Block block{};
    for (std::int64_t b = K.rowPtr[std::size_t(r)]; b < K.rowPtr[std::size_t(r) + 1]; ++b) {
      const int other = numbers[std::size_t(K.cols[std::size_t(b)])];
      std::copy_n(K.values.data() + b * size, size, block.values);
      if (!nodes_.isFree(node) || !nodes_.isFree(other))
        mask(node, other, block);
      turnRows(node, vertex, block);
      const auto& ends = nodes_.ends(other);
      for (int end = 0; end < 2; ++end)
        addColumns(other, end, block, sum_.block(ends[std::size_t(end)]));
    }
  }

  void mask(int node, int other, Block& block) const
  {
    for (int i = 0; i < dim_; ++i)
      for (int j = 0; j < dim_; ++j)
        if (!nodes_.isInterior(node, i) || !nodes_.isInterior(other, j))
          block.values[i * dim_ + j] = 0.0;
  }

  /// block := P_node,vertex^T block
  void turnRows(int node, int vertex, Block& block) const
  {
    const auto& ends = nodes_.ends(node);
    const double* W = nodes_.blocks(node);
    if (!W) {
      const double share = ends[0] == ends[1] ? 1.0 : 0.5;
      for (double& value : block.values)
        value *= share;
      return;
    }
    W += ends[0] == vertex ? 0 : dim_ * dim_;
    const Block given = block;
    for (int i = 0; i < dim_; ++i)
      for (int j = 0; j < dim_; ++j) {
        double sum = 0.0;
        for (int k = 0; k < dim_; ++k)
          sum += W[k * dim_ + i] * given.values[k * dim_ + j];
        block.values[i * dim_ + j] = sum;
      }
  }

  /// sum += block P_node,end; the halves of a vertex are two ends
  void addColumns(int node, int end, const Block& block, double* sum) const
  {
    const double* W = nodes_.blocks(node);
    if (!W) {
      for (int k = 0; k < dim_ * dim_; ++k)
        sum[k] += 0.5 * block.values[k];
      return;
    }
    W += std::ptrdiff_t(end) * dim_ * dim_;
    for (int i = 0; i < dim_; ++i)
      for (int j = 0; j < dim_; ++j)
        for (int k = 0; k < dim_; ++k)
          sum[i * dim_ + j] += block.values[i * dim_ + k] * W[k * dim_ + j];
  }

  const ProductNodes& nodes_;
  int dim_;
  std::vector<const BlockMatrix*> matrices_;
  std::vector<std::vector<int>> numbers_;    ///< of all nodes, per matrix and node that it holds
  std::vector<std::vector<Child>> children_; ///< per own vertex, rows that it is in
  BlockRowSum sum_;
};

BlockMatrix galerkinMatrix(const RankProblem& problem, const LinearInterpolation& P, const Comm& comm)
{
  const BlockMatrix& K = *problem.matrix;
  NDFRAME_ASSERT(!K.values.empty() || K.cols.empty(), "the matrix was given back");
  const auto endsOf = [&P](int row) {
    const auto& [a, b] = P.ends[std::size_t(row)];
    return std::vector<Global>{P.vertices.global(a), P.vertices.global(b)};
  };
  const BlockMatrix received = receivedRows(K, endsOf, comm);
  const ProductNodes nodes(problem, P, received.nodes, comm);
  GalerkinProduct product(K.dim, nodes);
  product.add(K);
  product.add(received);
  return std::move(product).product();
}

/// Own vertices and those that own nodes interpolate, by the numbers of their nodes. Collective.
IndexMap verticesOf(const RankProblem& problem, const Comm& comm)
{
  const IndexMap& nodes = problem.matrix->nodes;
  std::vector<Global> owned, needed;
  for (int r = 0; r < nodes.numOwned(); ++r)
    if (problem.isVertex(r))
      owned.push_back(nodes.global(r));
  Vector number{owned.empty() ? 0.0 : double(owned.back() + 1)}; // exact up to 2^53
  takeLargest(number, comm);
  const auto size = Global(number.front());
  for (int r = 0; r < nodes.numOwned() && Global(owned.size()) != size; ++r)
    for (const int end : problem.ends[std::size_t(r)])
      if (!nodes.owns(end))
        needed.push_back(nodes.global(end));
  return {size, std::move(owned), std::move(needed)};
}

} // namespace

LinearInterpolation::LinearInterpolation(const RankProblem& problem, const Comm& comm)
    : dim(problem.matrix->dim), vertices(verticesOf(problem, comm))
{
  const IndexMap& nodes = problem.matrix->nodes;
  const auto axesOf = [&](int node) -> const double* {
    const auto found = std::lower_bound(problem.turned.begin(), problem.turned.end(), node);
    return found == problem.turned.end() || *found != node
               ? nullptr
               : problem.axes.data() + (found - problem.turned.begin()) * dim * dim;
  };
  turned.assign(problem.turned.empty() ? 0 : problem.ends.size(), -1);
  for (std::size_t node = 0; node < turned.size(); ++node) {
    const auto& [a, b] = problem.ends[node];
    const double *middle = axesOf(int(node)), *first = axesOf(a), *second = axesOf(b);
    if (a == b || (!middle && !first && !second))
      continue;
    turned[node] = int(turnedBlocks.size()) / (2 * dim * dim);
    addTurnedHalf(middle, first, dim, turnedBlocks);
    addTurnedHalf(middle, second, dim, turnedBlocks);
  }
  ends.reserve(problem.ends.size());
  for (const auto& [a, b] : problem.ends)
    ends.push_back({vertices.local(nodes.global(a)), vertices.local(nodes.global(b))});
}

LinearLevel::LinearLevel(const RankProblem& fine, const Comm& comm)
    : interpolation(fine, comm), matrix(galerkinMatrix(fine, interpolation, comm))
{
  problem.matrix = &matrix;
  problem.nearNullSpace = fine.nearNullSpace;
  problem.nodePoints = fine.nodePoints;
  std::vector<char> isInterior;
  for (int r = 0; r < fine.matrix->numRows(); ++r)
    for (int i = 0; fine.isVertex(r) && i < matrix.dim; ++i)
      isInterior.push_back(fine.role(r, i) == DofRole::Interior);
  problem.roles = heldRoles(matrix.nodes, matrix.dim, isInterior, comm);
}

} // namespace ndframe

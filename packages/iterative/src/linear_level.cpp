#include "ndframe/iterative/linear_level.hpp"

#include <algorithm>
#include <numeric>

#include "block_row_sum.hpp"
#include "ndframe/algebra/shared_rows.hpp"

namespace ndframe
{

namespace
{

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
  GalerkinProduct(const SolverProblem& problem, const LinearInterpolation& interpolation)
      : problem_(problem), P_(interpolation), dim_(interpolation.dim), children_(P_.vertices.size()),
        sum_(dim_, int(P_.vertices.size()))
  {
    for (std::size_t node = 0; node < P_.ends.size(); ++node) {
      const auto first = problem.roles.begin() + std::ptrdiff_t(node) * std::ptrdiff_t(dim_);
      isFree_.push_back(std::all_of(first, first + dim_, [](DofRole role) { return role == DofRole::Interior; }));
    }
  }

  /// Takes part with its rows, which must stay where they are.
  void add(const BlockMatrix& rows)
  {
    for (int r = 0; r < rows.numRows(); ++r) {
      const auto& [a, b] = P_.ends[std::size_t(rows.rowNode(r))];
      children_[std::size_t(a)].emplace_back(&rows, r);
      if (a != b)
        children_[std::size_t(b)].emplace_back(&rows, r);
    }
  }

  BlockMatrix rowsOf(const std::vector<int>& vertices) &&
  {
    for (const int vertex : vertices) {
      for (const auto& [rows, r] : children_[std::size_t(vertex)])
        addProduct(*rows, r, vertex);
      sum_.end(vertex);
    }
    return std::move(sum_).take();
  }

private:
  /// Adds (P^T)_vertex,i K_ij P_jq for all j and q.
  void addProduct(const BlockMatrix& K, int r, int vertex)
  {
    const int node = K.rowNode(r), size = dim_ * dim_;
    Block block{};
    for (std::int64_t b = K.rowPtr[std::size_t(r)]; b < K.rowPtr[std::size_t(r) + 1]; ++b) {
      const int other = K.colNode(b);
      std::copy_n(K.values.data() + b * size, size, block.values);
      if (!isFree_[std::size_t(node)] || !isFree_[std::size_t(other)])
        mask(node, other, block);
      turnRows(node, vertex, block);
      const auto& ends = P_.ends[std::size_t(other)];
      for (int end = 0; end < 2; ++end)
        addColumns(other, end, block, sum_.block(ends[std::size_t(end)]));
    }
  }

  void mask(int node, int other, Block& block) const
  {
    for (int i = 0; i < dim_; ++i)
      for (int j = 0; j < dim_; ++j)
        if (!isInterior(node, i) || !isInterior(other, j))
          block.values[i * dim_ + j] = 0.0;
  }

  bool isInterior(int node, int component) const
  {
    return problem_.roles[std::size_t(node) * std::size_t(dim_) + std::size_t(component)] == DofRole::Interior;
  }

  /// block := P_node,vertex^T block
  void turnRows(int node, int vertex, Block& block) const
  {
    const auto& ends = P_.ends[std::size_t(node)];
    const double* W = P_.blocks(node);
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
    const double* W = P_.blocks(node);
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

  const SolverProblem& problem_;
  const LinearInterpolation& P_;
  int dim_;
  std::vector<std::vector<std::pair<const BlockMatrix*, int>>> children_; ///< per vertex, rows that it is in
  std::vector<char> isFree_; ///< per node, whether all its dofs are interior
  BlockRowSum sum_;
};

BlockMatrix galerkinMatrix(const SolverProblem& problem, const LinearInterpolation& P, const Comm& comm)
{
  const BlockMatrix& K = *problem.matrix;
  const auto endsOf = [&P](int node) {
    const auto& [a, b] = P.ends[std::size_t(node)];
    return std::vector<int>{P.vertices[std::size_t(a)], P.vertices[std::size_t(b)]};
  };
  const BlockMatrix received = receivedRows(K, endsOf, comm);
  GalerkinProduct product(problem, P);
  product.add(K);
  product.add(received);
  std::vector<int> own;
  for (int r = 0; r < K.numRows(); ++r)
    if (const auto& [a, b] = P.ends[std::size_t(K.rowNode(r))]; a == b)
      own.push_back(a);
  return std::move(product).rowsOf(own);
}

/// Of this rank's own vertices, from values of all nodes or of these.
class OwnValues
{
public:
  OwnValues(const SolverProblem& fine, const LinearInterpolation& P, const BlockMatrix& level)
      : P_(P), level_(level), numDofs_(fine.matrix->numDofs())
  {}
  /// To `own`, at the dofs of own vertices; size: of `given`.
  void take(const double* given, int size, double* own) const
  {
    for (int v = 0; v < level_.numRows(); ++v) {
      const int from = size == numDofs_ ? P_.vertices[std::size_t(level_.rowNode(v))] : v;
      own = std::copy_n(given + std::ptrdiff_t(from) * P_.dim, P_.dim, own);
    }
  }
  int size() const { return level_.numRows() * P_.dim; }

private:
  const LinearInterpolation& P_;
  const BlockMatrix& level_;
  int numDofs_;
};

} // namespace

LinearInterpolation::LinearInterpolation(const EdgeNodes& nodes, int dimension) : dim(dimension), ends(nodes.ends)
{
  std::vector<int> number(ends.size(), -1);
  for (std::size_t node = 0; node < ends.size(); ++node)
    if (ends[node][0] == ends[node][1]) {
      number[node] = int(vertices.size());
      vertices.push_back(int(node));
    }
  const auto axesOf = [&](int node) -> const double* {
    const auto found = std::lower_bound(nodes.turned.begin(), nodes.turned.end(), node);
    return found == nodes.turned.end() || *found != node
               ? nullptr
               : nodes.axes.data() + (found - nodes.turned.begin()) * dim * dim;
  };
  turned.assign(nodes.turned.empty() ? 0 : ends.size(), -1);
  for (std::size_t node = 0; node < turned.size(); ++node) {
    const auto& [a, b] = ends[node];
    const double *middle = axesOf(int(node)), *first = axesOf(a), *second = axesOf(b);
    if (a == b || (!middle && !first && !second))
      continue;
    turned[node] = int(turnedBlocks.size()) / (2 * dim * dim);
    addTurnedHalf(middle, first, dim, turnedBlocks);
    addTurnedHalf(middle, second, dim, turnedBlocks);
  }
  for (auto& [a, b] : ends) {
    a = number[std::size_t(a)];
    b = number[std::size_t(b)];
  }
}

LinearLevel::LinearLevel(const SolverProblem& fine, const Comm& comm)
    : interpolation(fine.edgeNodes, fine.matrix->dim), matrix(galerkinMatrix(fine, interpolation, comm))
{
  problem.matrix = &matrix;
  const DenseMatrix& modes = fine.nearNullSpace;
  const OwnValues values(fine, interpolation, matrix);
  problem.nearNullSpace = DenseMatrix(modes.cols() == 0 ? 0 : values.size(), modes.cols());
  for (int m = 0; m < modes.cols(); ++m)
    values.take(modes.col(m), modes.rows(), problem.nearNullSpace.col(m));
  if (!fine.nodePoints.empty()) {
    problem.nodePoints.resize(std::size_t(values.size()));
    values.take(fine.nodePoints.data(), int(fine.nodePoints.size()), problem.nodePoints.data());
  }
  for (const int vertex : interpolation.vertices)
    for (int i = 0; i < matrix.dim; ++i) {
      const auto dof = std::size_t(vertex) * std::size_t(matrix.dim) + std::size_t(i);
      problem.roles.push_back(fine.roles[dof] == DofRole::Interior ? DofRole::Interior : DofRole::Fixed);
    }
}

} // namespace ndframe

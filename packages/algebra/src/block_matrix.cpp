#include "ndframe/algebra/block_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ndframe/algebra/dense.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/base/memory.hpp"

namespace ndframe
{

namespace
{

/// Gives the columns this rank's numbers, number[column]. Owned ones come first; they and ghosts stay ascending.
void renumberRow(BlockMatrix& K, std::size_t r, const std::vector<int>& number,
                 std::vector<std::pair<int, std::int64_t>>& order)
{
  const std::int64_t first = K.rowPtr[r], last = K.rowPtr[r + 1], size = std::int64_t(K.dim) * K.dim;
  order.clear();
  for (const bool owned : {true, false})
    for (std::int64_t b = first; b < last; ++b)
      if (const int column = number[std::size_t(K.cols[std::size_t(b)])]; K.nodes.owns(column) == owned)
        order.emplace_back(column, b - first);
  for (std::int64_t b = first; b < last; ++b)
    K.cols[std::size_t(b)] = order[std::size_t(b - first)].first;
  if (K.values.empty())
    return;
  const std::vector<double> given(K.values.begin() + first * size, K.values.begin() + last * size);
  for (std::int64_t b = first; b < last; ++b)
    std::copy_n(given.begin() + order[std::size_t(b - first)].second * size, size, K.values.begin() + b * size);
}

} // namespace

void BlockMatrix::makeValues()
{
  const std::size_t size = cols.size() * std::size_t(dim) * std::size_t(dim);
  values.reserve(size);
  useLargePages(values.data(), size * sizeof(double));
  values.resize(size, 0.0);
}

BlockMatrix withOwnColumns(int dim, IndexMap::Global numNodes, const std::vector<int>& owned,
                           std::vector<std::int64_t> rowPtr, std::vector<int> cols, std::vector<double> values)
{
  const bool isWhole = IndexMap::Global(owned.size()) == numNodes;
  std::vector<IndexMap::Global> needed;
  std::vector<int> number(isWhole ? 0 : std::size_t(numNodes), -1);
  for (const int node : cols)
    if (!isWhole && std::exchange(number[std::size_t(node)], 0) < 0)
      needed.push_back(node);
  BlockMatrix K{dim, IndexMap(numNodes, {owned.begin(), owned.end()}, std::move(needed)), std::move(rowPtr),
                std::move(cols), std::move(values)};
  for (int node = 0; !isWhole && node < K.nodes.size(); ++node)
    number[std::size_t(K.nodes.global(node))] = node;
  std::vector<std::pair<int, std::int64_t>> order;
  for (std::size_t r = 0; !isWhole && r < owned.size(); ++r)
    renumberRow(K, r, number, order);
  K.makeValues();
  return K;
}

BlockMatrix withoutIdleGhosts(int dim, const IndexMap& nodes, std::vector<std::int64_t> rowPtr, std::vector<int> cols,
                              std::vector<double> values)
{
  std::vector<char> isColumn(nodes.isWhole() ? 0 : std::size_t(nodes.size()), 0);
  for (std::size_t b = 0; b < cols.size() && !nodes.isWhole(); ++b)
    isColumn[std::size_t(cols[b])] = 1;
  std::vector<IndexMap::Global> owned, ghosts;
  std::vector<int> number;
  for (std::size_t node = 0; node < isColumn.size(); ++node) {
    number.push_back(int(owned.size() + ghosts.size()));
    if (nodes.owns(int(node)))
      owned.push_back(nodes.global(int(node)));
    else if (isColumn[node])
      ghosts.push_back(nodes.global(int(node)));
  }
  for (std::size_t b = 0; b < cols.size() && !nodes.isWhole(); ++b)
    cols[b] = number[std::size_t(cols[b])];
  const IndexMap held = nodes.isWhole() ? nodes : IndexMap(nodes.globalSize(), std::move(owned), std::move(ghosts));
  BlockMatrix K{dim, held, std::move(rowPtr), std::move(cols), std::move(values)};
  K.makeValues();
  return K;
}

int BlockMatrix::rowOf(IndexMap::Global node) const
{
  const int row = nodes.local(node);
  return nodes.owns(row) ? row : -1;
}

const double* BlockMatrix::block(int r, int column) const
{
  const auto first = cols.begin() + rowPtr[std::size_t(r)], last = cols.begin() + rowPtr[std::size_t(r) + 1];
  const auto found = std::lower_bound(first, last, column);
  if (found == last || *found != column)
    return nullptr;
  return values.data() + (found - cols.begin()) * dim * dim;
}

double* BlockMatrix::block(int r, int column)
{
  return const_cast<double*>(static_cast<const BlockMatrix&>(*this).block(r, column));
}

Vector multiply(const BlockMatrix& K, const Vector& x, const Comm& comm)
{
  NDFRAME_ASSERT(int(x.size()) == K.numDofs(), "shapes do not match");
  Vector y(x.size(), 0.0);
  addProduct(K, x, y, [&K](int node) { return K.nodes.global(node); });
  comm.sum(y);
  return y;
}

Vector diagonal(const BlockMatrix& K, const Comm& comm)
{
  Vector d(std::size_t(K.numDofs()), 0.0);
  for (int r = 0; r < K.numRows(); ++r) {
    const double* entry = K.block(r, r);
    NDFRAME_ASSERT(entry != nullptr, "a row has no diagonal block");
    for (int i = 0; i < K.dim; ++i)
      d[std::size_t(K.rowNode(r)) * std::size_t(K.dim) + std::size_t(i)] = entry[i * K.dim + i];
  }
  comm.sum(d);
  return d;
}

} // namespace ndframe

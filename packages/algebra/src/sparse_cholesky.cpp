#include "ndframe/algebra/sparse_cholesky.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "cholmod_factor.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ordering.hpp"

namespace ndframe
{
namespace
{

/// Entries sorted into buckets by a key below `count`, in their order.
std::vector<std::size_t> sortedBy(const std::vector<int>& keys, const std::vector<std::size_t>& order, int count)
{
  std::vector<std::size_t> starts(std::size_t(count) + 1, 0), sorted(order.size());
  for (const int key : keys)
    ++starts[std::size_t(key) + 1];
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  for (const std::size_t entry : order)
    sorted[starts[std::size_t(keys[entry])]++] = entry;
  return sorted;
}

UpperTriangle compressed(const SymmetricEntries& A)
{
  std::vector<std::size_t> order(A.values.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  order = sortedBy(A.columns, sortedBy(A.rows, order, A.size), A.size);
  UpperTriangle U;
  U.colPtr.assign(std::size_t(A.size) + 1, 0);
  int column = -1;
  for (const std::size_t entry : order) {
    NDFRAME_ASSERT(A.rows[entry] <= A.columns[entry], "an entry of the lower triangle");
    if (A.columns[entry] == column && U.rows.back() == A.rows[entry]) {
      U.values.back() += A.values[entry];
      continue;
    }
    column = A.columns[entry];
    U.rows.push_back(A.rows[entry]);
    U.values.push_back(A.values[entry]);
    ++U.colPtr[std::size_t(column) + 1];
  }
  std::partial_sum(U.colPtr.begin(), U.colPtr.end(), U.colPtr.begin());
  for (int k = 0; k < A.size; ++k) {
    const int last = U.colPtr[std::size_t(k) + 1];
    NDFRAME_ASSERT(last > U.colPtr[std::size_t(k)] && U.rows[std::size_t(last) - 1] == k, "no diagonal entry");
  }
  return U;
}

/// METIS on the graph of the matrix; it takes columns with the same neighbours together itself.
std::vector<int> dissected(const UpperTriangle& U)
{
  const int size = U.size();
  NodeGraph graph;
  graph.nodes.resize(std::size_t(size));
  std::iota(graph.nodes.begin(), graph.nodes.end(), 0);
  graph.starts.assign(std::size_t(size) + 1, 0);
  const auto forEachEdge = [&](const auto& visit) {
    for (int column = 0; column < size; ++column)
      for (int e = U.colPtr[std::size_t(column)]; e < U.colPtr[std::size_t(column) + 1] - 1; ++e)
        visit(U.rows[std::size_t(e)], column);
  };
  forEachEdge([&](int a, int b) {
    ++graph.starts[std::size_t(a) + 1];
    ++graph.starts[std::size_t(b) + 1];
  });
  std::partial_sum(graph.starts.begin(), graph.starts.end(), graph.starts.begin());
  graph.neighbours.resize(std::size_t(graph.starts.back()));
  std::vector<int> next(graph.starts.begin(), graph.starts.end() - 1);
  forEachEdge([&](int a, int b) {
    graph.neighbours[std::size_t(next[std::size_t(a)]++)] = b;
    graph.neighbours[std::size_t(next[std::size_t(b)]++)] = a;
  });
  return nestedDissection(std::move(graph));
}

} // namespace

struct SparseCholesky::Factor
{
  CholmodFactor L;
};

SparseCholesky::SparseCholesky(const SymmetricEntries& A)
{
  if (A.size == 0)
    return;
  UpperTriangle U = compressed(A);
  std::vector<int> order = dissected(U);
  try {
    // An aggregate that cannot be moved.
    factor_ = std::unique_ptr<Factor>(new Factor{{std::move(U), std::move(order), 0}}); // NOLINT(modernize-make-unique)
  } catch (const BadPivot& bad) {
    throw NotPositiveDefinite(bad.column);
  }
}

SparseCholesky::~SparseCholesky() = default;

Vector SparseCholesky::solve(const Vector& b) const
{
  if (!factor_)
    return b;
  const CholmodFactor& L = factor_->L;
  DenseMatrix x(L.size(), 1);
  for (int k = 0; k < L.size(); ++k)
    x(k, 0) = b[std::size_t(L.order(k))];
  L.forward(x);
  L.backward(x);
  Vector solution(b.size());
  for (int k = 0; k < L.size(); ++k)
    solution[std::size_t(L.order(k))] = x(k, 0);
  return solution;
}

} // namespace ndframe

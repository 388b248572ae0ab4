#include "ndframe/equilibrium/row_reduction.hpp"

#include <algorithm>
#include <cmath>

namespace ndframe
{
namespace
{

/// The largest entry in rows that have no pivot yet.
std::pair<int, int> largestEntry(const RowReduction& reduced, int columns)
{
  std::pair<int, int> at{-1, -1};
  double largest = 0.0;
  for (int j = 0; j < columns; ++j)
    for (int i = 0; i < reduced.matrix.rows(); ++i)
      if (reduced.pivot[std::size_t(i)] < 0 && std::abs(reduced.matrix(i, j)) > largest) {
        largest = std::abs(reduced.matrix(i, j));
        at = {i, j};
      }
  return at;
}

void eliminate(DenseMatrix& A, int row, int column)
{
  const double pivot = A(row, column);
  for (int j = 0; j < A.cols(); ++j)
    A(row, j) /= pivot;
  for (int i = 0; i < A.rows(); ++i) {
    const double factor = A(i, column);
    if (i == row || factor == 0.0)
      continue;
    for (int j = 0; j < A.cols(); ++j)
      A(i, j) -= factor * A(row, j);
    A(i, column) = 0.0;
  }
}

} // namespace

int RowReduction::rank() const
{
  return int(std::count_if(pivot.begin(), pivot.end(), [](int column) { return column >= 0; }));
}

RowReduction reduceRows(DenseMatrix A, int pivotColumns, double relativeTolerance)
{
  std::vector<int> noPivots(std::size_t(A.rows()), -1);
  RowReduction reduced{std::move(A), std::move(noPivots)};
  double threshold = 0.0;
  for (;;) {
    const auto [row, column] = largestEntry(reduced, pivotColumns);
    if (row < 0 || std::abs(reduced.matrix(row, column)) <= threshold)
      break;
    threshold = std::max(threshold, relativeTolerance * std::abs(reduced.matrix(row, column)));
    eliminate(reduced.matrix, row, column);
    reduced.pivot[std::size_t(row)] = column;
  }
  for (int i = 0; i < reduced.matrix.rows(); ++i)
    for (int j = 0; j < pivotColumns && reduced.pivot[std::size_t(i)] < 0; ++j)
      reduced.matrix(i, j) = 0.0;
  return reduced;
}

} // namespace ndframe

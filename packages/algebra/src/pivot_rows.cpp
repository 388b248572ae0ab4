#include "ndframe/algebra/pivot_rows.hpp"

#include <cmath>
#include <utility>

namespace ndframe
{
namespace
{

/// The row of largest norm, with its norm; norm 0 when all rows vanish.
std::pair<int, double> largestRow(const DenseMatrix& A)
{
  std::pair<int, double> largest{0, 0.0};
  for (int i = 0; i < A.rows(); ++i) {
    double square = 0.0;
    for (int j = 0; j < A.cols(); ++j)
      square += A(i, j) * A(i, j);
    if (square > largest.second)
      largest = {i, square};
  }
  return {largest.first, std::sqrt(largest.second)};
}

/// Removes the direction of one row from all rows.
void removeDirection(DenseMatrix& A, int row, double length)
{
  Vector direction;
  for (int j = 0; j < A.cols(); ++j)
    direction.push_back(A(row, j) / length);
  for (int i = 0; i < A.rows(); ++i) {
    double along = 0.0;
    for (int j = 0; j < A.cols(); ++j)
      along += A(i, j) * direction[std::size_t(j)];
    for (int j = 0; j < A.cols(); ++j)
      A(i, j) -= along * direction[std::size_t(j)];
  }
}

} // namespace

std::vector<int> pivotRows(DenseMatrix A)
{
  std::vector<int> pivots;
  for (int k = 0; k < A.cols(); ++k) {
    const auto [row, length] = largestRow(A);
    if (length == 0.0)
      break;
    pivots.push_back(row);
    removeDirection(A, row, length);
  }
  return pivots;
}

} // namespace ndframe

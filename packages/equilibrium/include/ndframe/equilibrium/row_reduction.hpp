#pragma once

#include <vector>

#include "ndframe/algebra/dense.hpp"

namespace ndframe
{

/// Rows reduced by Gauss-Jordan elimination with complete pivoting: every pivot column is a unit vector.
struct RowReduction
{
  DenseMatrix matrix;     ///< rows in their old order; no pivot: zero in the pivot columns
  std::vector<int> pivot; ///< per row its pivot column; -1 for rows that depend on others within the pivot columns

  int rank() const; ///< number of rows with a pivot
};

/// Pivots are taken from the first `pivotColumns` columns while they exceed `relativeTolerance` times the largest entry
/// there; the rest of every other row is set to zero in these columns.
RowReduction reduceRows(DenseMatrix A, int pivotColumns, double relativeTolerance);

} // namespace ndframe

#pragma once

#include <vector>

#include "ndframe/algebra/sparse_row.hpp"

namespace ndframe
{

/// A matrix of few entries a column, each column by ascending rows.
class SparseColumns
{
public:
  using Column = SparseRow;

  SparseColumns() = default;
  SparseColumns(int rows, int cols) : rows_(rows), columns_(std::size_t(cols)) {}
  SparseColumns(const DenseMatrix& A); // the entries that are not zero

  int rows() const { return rows_; }
  int cols() const { return int(columns_.size()); }
  const Column& column(int j) const { return columns_[std::size_t(j)]; }
  void setColumn(int j, const Vector& values);
  void setColumn(int j, Column column) { columns_[std::size_t(j)] = std::move(column); }
  /// An entry, which is there from then on.
  double& operator()(int i, int j);
  double operator()(int i, int j) const;

  /// A x, A^T x and the sum of |A_ij x_i| over a column j.
  Vector times(const Vector& x) const;
  Vector transposedTimes(const Vector& x) const;
  double magnitude(int j, const Vector& x) const;

private:
  int rows_ = 0;
  std::vector<Column> columns_;
};

} // namespace ndframe

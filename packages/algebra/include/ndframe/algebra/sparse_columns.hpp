#pragma once

#include <vector>

#include "ndframe/algebra/sparse_row.hpp"

namespace ndframe
{

/// A matrix of few entries a column, each column by ascending rows.
class SparseColumns
{
public:
  using Column = SparseRow; ///< rows and entries, rows ascending

  SparseColumns() = default;
  SparseColumns(int rows, int cols) : rows_(rows), columns_(std::size_t(cols)) {} ///< zero
  SparseColumns(const DenseMatrix& A);                                            ///< the entries that are not zero

  int rows() const { return rows_; }                                     ///< of the matrix
  int cols() const { return int(columns_.size()); }                      ///< of the matrix
  const Column& column(int j) const { return columns_[std::size_t(j)]; } ///< what is stored of it
  void setColumn(int j, const Vector& values); ///< values: rows() of them; zeros are not stored
  void setColumn(int j, Column column) { columns_[std::size_t(j)] = std::move(column); } ///< rows ascending
  /// An entry, which is there from then on.
  double& operator()(int i, int j);
  double operator()(int i, int j) const; ///< zero where none is stored

  /// A x, A^T x and the sum of |A_ij x_i| over a column j.
  Vector times(const Vector& x) const;
  Vector transposedTimes(const Vector& x) const;  ///< A^T x
  double magnitude(int j, const Vector& x) const; ///< sum_i |A_ij x_i|

private:
  int rows_ = 0;
  std::vector<Column> columns_;
};

} // namespace ndframe

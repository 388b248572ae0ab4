#pragma once

#include <algorithm>

#include "ndframe/algebra/dense.hpp"

namespace ndframe
{

/// Symmetric band matrix: the entries (i, j) with j <= i <= j + bandwidth, column by column (LAPACK's storage "L").
class BandMatrix
{
public:
  /// All entries zero. bandwidth: diagonals below the main one.
  BandMatrix(int size, int bandwidth)
      : size_(size), bandwidth_(bandwidth), values_(std::size_t(size) * std::size_t(bandwidth + 1), 0.0)
  {}

  int size() const { return size_; }           ///< rows
  int bandwidth() const { return bandwidth_; } ///< diagonals below the main one
  /// Either triangle may be named; |i - j| <= bandwidth.
  double& operator()(int i, int j) { return values_[place(i, j)]; }
  double operator()(int i, int j) const { return values_[place(i, j)]; } ///< the same, read-only
  const double* data() const { return values_.data(); } ///< (bandwidth + 1) x size, column-major, main diagonal first
  double* data() { return values_.data(); }             ///< the same, to be written

private:
  std::size_t place(int i, int j) const
  {
    const int column = std::min(i, j), below = std::max(i, j) - column;
    return std::size_t(column) * std::size_t(bandwidth_ + 1) + std::size_t(below);
  }

  int size_, bandwidth_;
  std::vector<double> values_;
};

/// Cholesky factor of a positive definite band matrix (LAPACK dpbtrf): size * bandwidth^2 operations.
class BandCholesky
{
public:
  /// Throws NotPositiveDefinite (with the row).
  explicit BandCholesky(BandMatrix A);
  Vector solve(Vector b) const; ///< A^-1 b

private:
  BandMatrix factor_;
};

} // namespace ndframe

#pragma once

#include <memory>
#include <vector>

#include "ndframe/algebra/dense.hpp"

namespace ndframe
{

/// A symmetric matrix as a list of entries of its upper triangle (row <= column), in any order; those of one place are
/// added.
struct SymmetricEntries
{
  int size = 0;                                     ///< rows of the matrix
  std::vector<int> rows, /**< per entry */ columns; ///< per entry, not below its row
  Vector values;                                    ///< per entry

  /// row <= column < size.
  void add(int row, int column, double value)
  {
    rows.push_back(row);
    columns.push_back(column);
    values.push_back(value);
  }
};

/// A = L L^T of a sparse symmetric positive definite matrix on one process: CHOLMOD, supernodal, in METIS's nested
/// dissection. Every row needs a diagonal entry.
class SparseCholesky
{
public:
  /// Throws NotPositiveDefinite (with the row) when a pivot is not above 1e-12 of its diagonal entry.
  explicit SparseCholesky(const SymmetricEntries& A);
  ~SparseCholesky();
  Vector solve(const Vector& b) const; ///< A^-1 b, in the rows' own order

private:
  struct Factor;
  std::unique_ptr<Factor> factor_; ///< null for a matrix without rows
};

} // namespace ndframe

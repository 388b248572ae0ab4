#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <vector>

#include <cholmod.h>

#include "factor_progress.hpp"
#include "ndframe/algebra/dense.hpp"

namespace ndframe
{

/// Upper triangle of a sparse symmetric matrix by columns, rows ascending (the diagonal is a column's last entry).
struct UpperTriangle
{
  std::vector<int> colPtr;
  std::vector<int> rows;
  std::vector<double> values;

  int size() const { return int(colPtr.size()) - 1; }
  double diagonal(int column) const { return values[std::size_t(colPtr[std::size_t(column) + 1]) - 1]; }
  double& diagonal(int column) { return values[std::size_t(colPtr[std::size_t(column) + 1]) - 1]; }
};

/// CHOLMOD, quiet, for supernodal factors in the order that it is given.
void startCholmod(cholmod_common& common);

/// CHOLMOD's view of a matrix of ours; nothing is copied.
cholmod_sparse viewOf(UpperTriangle& A);
cholmod_dense viewOf(DenseMatrix& X);

/// A pivot that is not positive, or nothing but round-off.
class BadPivot : public std::runtime_error
{
public:
  explicit BadPivot(int badColumn) : std::runtime_error("a pivot is not positive"), column(badColumn) {}
  int column; ///< in the numbering of the matrix
};

/// Supernodal Cholesky factor P A P^T = L L^T whose last rows stay where the given order puts them:
///
///   L = [ L_ii      ]
///       [ L_ci   T  ],   T T^T = A_cc - A_ci A_ii^-1 A_ic.
///
/// Vectors of forward() and backward() are in the order of elimination: entry k belongs to column order()[k].
class CholmodFactor
{
public:
  /// `order`: position -> column; its last numKept positions are not moved. Throws BadPivot when a pivot is not above
  /// round-off relative to its diagonal entry. tell: hears how far a long factorisation is.
  CholmodFactor(UpperTriangle A, std::vector<int> order, int numKept, const FactorProgress::Tell& tell = {});
  CholmodFactor(const CholmodFactor&) = delete;
  CholmodFactor& operator=(const CholmodFactor&) = delete;
  ~CholmodFactor();

  int size() const { return int(factor_->n); }
  int order(int position) const { return static_cast<const int*>(factor_->Perm)[position]; }
  std::int64_t numNonzeros() const { return numNonzeros_; }

  /// X := L^-1 X, every column.
  void forward(DenseMatrix& X) const;
  /// X := L^-T X, every column.
  void backward(DenseMatrix& X) const;
  /// T, numKept x numKept, zero above the diagonal.
  DenseMatrix trailingBlock() const;
  /// T^T x, T y, and T^-T T^-1 b without forming T.
  Vector trailingTransposedTimes(const double* x) const;
  Vector trailingTimes(const double* y) const;
  Vector trailingSolve(Vector b) const;

private:
  void analyse(cholmod_sparse& view, std::vector<int> order);
  bool keptAreLast(const std::vector<int>& order) const;
  void checkPivots(const UpperTriangle& A) const;
  /// Calls visit(column position, row positions, entries, number of entries) for the columns from `firstColumn` on,
  /// the diagonal entry first.
  template <class Visit>
  void forEachColumn(int firstColumn, Visit visit) const;
  void findTrailingColumns();
  using Sweep = int (*)(cholmod_factor*, cholmod_dense*, cholmod_dense*, cholmod_common*);
  void solveInPlace(Sweep sweep, DenseMatrix& X) const;

  mutable cholmod_common common_;
  cholmod_factor* factor_ = nullptr;
  int numKept_;
  std::int64_t numNonzeros_ = 0;

  /// A column of T, from its diagonal entry on.
  struct TrailingColumn
  {
    const int* rows; ///< in the order of elimination
    const double* entries;
    int count;
  };
  std::vector<TrailingColumn> trailing_;
};

} // namespace ndframe

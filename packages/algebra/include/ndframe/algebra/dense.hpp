#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "ndframe/algebra/comm.hpp"

namespace ndframe
{

/// Column-major dense matrix.
class DenseMatrix
{
public:
  DenseMatrix() = default;
  /// All entries zero.
  DenseMatrix(int rows, int cols) : rows_(rows), cols_(cols), values_(std::size_t(rows) * std::size_t(cols), 0.0) {}
  /// One column.
  explicit DenseMatrix(Vector column) : rows_(int(column.size())), cols_(1), values_(std::move(column)) {}

  int rows() const { return rows_; } ///< entries of a column
  int cols() const { return cols_; } ///< columns
  /// Row i, column j, from 0; not checked.
  double& operator()(int i, int j) { return values_[std::size_t(i) + std::size_t(j) * std::size_t(rows_)]; }
  /// The same, read-only.
  double operator()(int i, int j) const { return values_[std::size_t(i) + std::size_t(j) * std::size_t(rows_)]; }
  double* col(int j) { return values_.data() + std::size_t(j) * std::size_t(rows_); }             ///< rows() entries
  const double* col(int j) const { return values_.data() + std::size_t(j) * std::size_t(rows_); } ///< the same
  Vector column(int j) const { return Vector(col(j), col(j) + rows_); }                           ///< a copy
  double* data() { return values_.data(); }             ///< rows() x cols() entries, column by column
  const double* data() const { return values_.data(); } ///< the same

private:
  int rows_ = 0, cols_ = 0;
  std::vector<double> values_;
};

/// y = A x for symmetric A (both triangles stored), BLAS dsymv.
Vector multiplySymmetric(const DenseMatrix& A, const Vector& x);
/// A x and A^T x, BLAS dgemv.
Vector multiply(const DenseMatrix& A, const Vector& x);
Vector multiplyTransposed(const DenseMatrix& A, const Vector& x); ///< A^T x, dgemv

/// A B and A^T B, BLAS dgemm.
DenseMatrix multiply(const DenseMatrix& A, const DenseMatrix& B);
DenseMatrix multiplyTransposed(const DenseMatrix& A, const DenseMatrix& B); ///< A^T B, dgemm

/// Cholesky factor of a dense symmetric positive definite matrix (LAPACK dpotrf).
class DenseCholesky
{
public:
  /// Throws NotPositiveDefinite (with the row) when a pivot is not above `relativePivot` times the largest diagonal
  /// entry.
  explicit DenseCholesky(DenseMatrix A, double relativePivot = 1e-13);
  Vector solve(Vector b) const; ///< A^-1 b
  /// L^-1 b and L^-T b, A = L L^T: half a solution each.
  Vector solveLower(Vector b) const;
  Vector solveUpper(Vector b) const;           ///< L^-T b
  DenseMatrix solveLower(DenseMatrix B) const; ///< L^-1 B, BLAS dtrsm
  /// A^-1.
  DenseMatrix inverse() const;
  int size() const { return factor_.rows(); } ///< rows of A

private:
  DenseMatrix factor_;
};

/// A factorisation met a pivot that is not positive.
class NotPositiveDefinite : public std::runtime_error
{
public:
  /// firstRow: as `row`.
  explicit NotPositiveDefinite(int firstRow)
      : std::runtime_error("a matrix is not positive definite at row " + std::to_string(firstRow)), row(firstRow)
  {}
  int row; ///< first row whose pivot vanishes; -1 when it is not known
};

/// Orthonormal basis (columns) of the null space of A, singular values below `relativeTolerance` times the largest are
/// zero. A may have zero rows or be zero: then the whole space is returned.
DenseMatrix nullSpace(const DenseMatrix& A, double relativeTolerance);

/// Moore-Penrose inverse, cols x rows; singular values below `relativeTolerance` times the largest are zero.
DenseMatrix pseudoInverse(const DenseMatrix& A, double relativeTolerance);

/// All eigenvalues of a symmetric matrix in ascending order (LAPACK dsyev, lower triangle).
Vector symmetricEigenvalues(DenseMatrix A);

/// sum a_i b_i, and the Euclidean norm; of vectors of one length.
double dot(const Vector& a, const Vector& b);
double norm(const Vector& a);                 ///< (sum a_i^2)^(1/2)
Vector difference(Vector a, const Vector& b); ///< a - b
/// The largest absolute value; 0 without entries.
double largestEntry(const Vector& a);

} // namespace ndframe

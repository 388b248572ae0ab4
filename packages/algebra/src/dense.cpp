#include "ndframe/algebra/dense.hpp"

#include <algorithm>
#include <cmath>

#include <cblas.h>

#include "lapack.hpp"
#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

Vector multiplySymmetric(const DenseMatrix& A, const Vector& x)
{
  NDFRAME_ASSERT(A.rows() == A.cols() && A.cols() == int(x.size()), "shapes do not match");
  Vector y(x.size(), 0.0);
  if (!x.empty())
    cblas_dsymv(CblasColMajor, CblasLower, A.rows(), 1.0, A.data(), A.rows(), x.data(), 1, 0.0, y.data(), 1);
  return y;
}

namespace
{

Vector product(CBLAS_TRANSPOSE transpose, int rows, int inner, const DenseMatrix& A, const Vector& x)
{
  NDFRAME_ASSERT(inner == int(x.size()), "shapes do not match");
  Vector y(std::size_t(rows), 0.0);
  if (rows > 0 && inner > 0)
    cblas_dgemv(CblasColMajor, transpose, A.rows(), A.cols(), 1.0, A.data(), A.rows(), x.data(), 1, 0.0, y.data(), 1);
  return y;
}

DenseMatrix product(CBLAS_TRANSPOSE transpose, int rows, int inner, const DenseMatrix& A, const DenseMatrix& B)
{
  NDFRAME_ASSERT(inner == B.rows(), "shapes do not match");
  DenseMatrix C(rows, B.cols());
  if (rows > 0 && inner > 0 && B.cols() > 0)
    cblas_dgemm(CblasColMajor, transpose, CblasNoTrans, rows, B.cols(), inner, 1.0, A.data(), A.rows(), B.data(), inner,
                0.0, C.data(), rows);
  return C;
}

} // namespace

Vector multiply(const DenseMatrix& A, const Vector& x)
{
  return product(CblasNoTrans, A.rows(), A.cols(), A, x);
}

Vector multiplyTransposed(const DenseMatrix& A, const Vector& x)
{
  return product(CblasTrans, A.cols(), A.rows(), A, x);
}

DenseMatrix multiply(const DenseMatrix& A, const DenseMatrix& B)
{
  return product(CblasNoTrans, A.rows(), A.cols(), A, B);
}

DenseMatrix multiplyTransposed(const DenseMatrix& A, const DenseMatrix& B)
{
  return product(CblasTrans, A.cols(), A.rows(), A, B);
}

DenseCholesky::DenseCholesky(DenseMatrix A, double relativePivot) : factor_(std::move(A))
{
  const int n = factor_.rows();
  NDFRAME_ASSERT(n == factor_.cols(), "a Cholesky factor needs a square matrix");
  if (n == 0)
    return;
  double largest = 0.0;
  for (int i = 0; i < n; ++i)
    largest = std::max(largest, factor_(i, i));
  int info = 0;
  dpotrf_("L", &n, factor_.data(), &n, &info);
  NDFRAME_ASSERT(info >= 0, "dpotrf refused an argument");
  const int done = info > 0 ? info - 1 : n;
  for (int i = 0; i < done; ++i)
    if (factor_(i, i) * factor_(i, i) <= relativePivot * largest)
      throw NotPositiveDefinite{i};
  if (info > 0)
    throw NotPositiveDefinite{info - 1};
}

namespace
{

/// L^-1 b, or L^-T b when transposed.
Vector solveTriangle(const DenseMatrix& L, CBLAS_TRANSPOSE transposed, Vector b)
{
  const int n = L.rows();
  NDFRAME_ASSERT(n == int(b.size()), "shapes do not match");
  if (n > 0)
    cblas_dtrsv(CblasColMajor, CblasLower, transposed, CblasNonUnit, n, L.data(), n, b.data(), 1);
  return b;
}

} // namespace

/// Not dpotrs, which packs the triangle anew for every call: most of its time, when there is one right-hand side.
Vector DenseCholesky::solve(Vector b) const
{
  return solveUpper(solveLower(std::move(b)));
}

Vector DenseCholesky::solveLower(Vector b) const
{
  return solveTriangle(factor_, CblasNoTrans, std::move(b));
}

Vector DenseCholesky::solveUpper(Vector b) const
{
  return solveTriangle(factor_, CblasTrans, std::move(b));
}

DenseMatrix DenseCholesky::solveLower(DenseMatrix B) const
{
  const int n = factor_.rows();
  NDFRAME_ASSERT(B.rows() == n, "shapes do not match");
  if (n > 0 && B.cols() > 0)
    cblas_dtrsm(CblasColMajor, CblasLeft, CblasLower, CblasNoTrans, CblasNonUnit, n, B.cols(), 1.0, factor_.data(), n,
                B.data(), n);
  return B;
}

DenseMatrix DenseCholesky::inverse() const
{
  DenseMatrix result = factor_;
  const int n = result.rows();
  int info = 0;
  if (n > 0)
    dpotri_("L", &n, result.data(), &n, &info);
  NDFRAME_ASSERT(info == 0, "pivots are positive");
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < j; ++i)
      result(i, j) = result(j, i);
  return result;
}

DenseMatrix nullSpace(const DenseMatrix& A, double relativeTolerance)
{
  const int m = A.rows(), n = A.cols(), lda = std::max(1, m), least = std::min(m, n);
  DenseMatrix copy = A, rightT(n, n);
  for (int i = 0; i < n; ++i)
    rightT(i, i) = 1.0;
  Vector singular(std::size_t(n), 0.0);
  if (least > 0) {
    int info = 0, query = -1;
    const int one = 1;
    double best = 0.0;
    dgesvd_("N", "A", &m, &n, copy.data(), &lda, singular.data(), nullptr, &one, rightT.data(), &n, &best, &query,
            &info);
    const int length = int(best);
    Vector work(std::size_t(length), 0.0);
    dgesvd_("N", "A", &m, &n, copy.data(), &lda, singular.data(), nullptr, &one, rightT.data(), &n, work.data(),
            &length, &info);
    NDFRAME_ASSERT(info == 0, "the singular value decomposition failed (are all entries finite?)");
  }
  // Singular values descend, and those that a wide matrix does not have are zero.
  int rank = 0;
  while (rank < n && singular[std::size_t(rank)] > relativeTolerance * singular[0])
    ++rank;
  DenseMatrix basis(n, n - rank);
  for (int j = rank; j < n; ++j)
    for (int i = 0; i < n; ++i)
      basis(i, j - rank) = rightT(j, i);
  return basis;
}

DenseMatrix pseudoInverse(const DenseMatrix& A, double relativeTolerance)
{
  const int m = A.rows(), n = A.cols(), least = std::min(m, n), query = -1;
  if (least == 0)
    return DenseMatrix(n, m);
  DenseMatrix copy = A, left(m, least), rightT(least, n);
  Vector singular(std::size_t(least), 0.0), work(1);
  int info = 0;
  const auto decompose = [&](const int* length) {
    dgesvd_("S", "S", &m, &n, copy.data(), &m, singular.data(), left.data(), &m, rightT.data(), &least, work.data(),
            length, &info);
  };
  decompose(&query);
  const int length = int(work[0]);
  work.resize(std::size_t(length));
  decompose(&length);
  NDFRAME_ASSERT(info == 0, "the singular value decomposition failed (are all entries finite?)");
  DenseMatrix leftT(least, m);
  for (int k = 0; k < least; ++k)
    if (const double value = singular[std::size_t(k)]; value > relativeTolerance * singular[0])
      for (int i = 0; i < m; ++i)
        leftT(k, i) = left(i, k) / value;
  return multiplyTransposed(rightT, leftT);
}

Vector symmetricEigenvalues(DenseMatrix A)
{
  const int n = A.rows(), workSize = 3 * n;
  NDFRAME_ASSERT(n == A.cols(), "eigenvalues need a square matrix");
  Vector values(static_cast<std::size_t>(n)), work(static_cast<std::size_t>(workSize));
  int info = 0;
  if (n > 0)
    dsyev_("N", "L", &n, A.data(), &n, values.data(), work.data(), &workSize, &info);
  NDFRAME_ASSERT(info == 0, "dsyev found no eigenvalues");
  return values;
}

double dot(const Vector& a, const Vector& b)
{
  NDFRAME_ASSERT(a.size() == b.size(), "shapes do not match");
  return cblas_ddot(int(a.size()), a.data(), 1, b.data(), 1);
}

double norm(const Vector& a)
{
  return cblas_dnrm2(int(a.size()), a.data(), 1);
}

Vector difference(Vector a, const Vector& b)
{
  NDFRAME_ASSERT(a.size() == b.size(), "vectors of different lengths");
  for (std::size_t i = 0; i < a.size(); ++i)
    a[i] -= b[i];
  return a;
}

double largestEntry(const Vector& a)
{
  double largest = 0.0;
  for (const double value : a)
    largest = std::max(largest, std::abs(value));
  return largest;
}

} // namespace ndframe

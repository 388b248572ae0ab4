#include "ndframe/algebra/symmetric_operator.hpp"

#include <utility>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

namespace
{

std::vector<int> indicesOf(const std::vector<char>& isFree)
{
  std::vector<int> indices;
  for (std::size_t i = 0; i < isFree.size(); ++i)
    if (isFree[i])
      indices.push_back(int(i));
  return indices;
}

/// A_FF + shift I.
DenseMatrix submatrix(const DenseMatrix& A, const std::vector<int>& indices, double shift)
{
  const int n = int(indices.size());
  DenseMatrix sub(n, n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      sub(i, j) = A(indices[std::size_t(i)], indices[std::size_t(j)]);
  for (int i = 0; i < n; ++i)
    sub(i, i) += shift;
  return sub;
}

/// The factor of A_FF + shift I; a row of it is reported by its number in A.
DenseCholesky factorOf(const DenseMatrix& A, const std::vector<int>& indices, double shift)
{
  try {
    return DenseCholesky(submatrix(A, indices, shift));
  } catch (const NotPositiveDefinite& failure) {
    throw NotPositiveDefinite{indices[std::size_t(failure.row)]};
  }
}

class DenseInverse final : public RestrictedInverse
{
public:
  DenseInverse(const DenseMatrix& A, std::vector<int> indices, double shift)
      : size_(std::size_t(A.rows())), indices_(std::move(indices)), factor_(factorOf(A, indices_, shift))
  {}

  Vector solve(const Vector& b) const override
  {
    NDFRAME_ASSERT(b.size() == size_, "shapes do not match");
    Vector restricted(indices_.size());
    for (std::size_t i = 0; i < indices_.size(); ++i)
      restricted[i] = b[std::size_t(indices_[i])];
    restricted = factor_.solve(std::move(restricted));
    Vector x(size_, 0.0);
    for (std::size_t i = 0; i < indices_.size(); ++i)
      x[std::size_t(indices_[i])] = restricted[i];
    return x;
  }

private:
  std::size_t size_;
  std::vector<int> indices_;
  DenseCholesky factor_;
};

class DenseOperator final : public SymmetricOperator
{
public:
  explicit DenseOperator(DenseMatrix A) : A_(std::move(A))
  {
    NDFRAME_ASSERT(A_.rows() == A_.cols(), "an operator needs a square matrix");
  }

  int size() const override { return A_.rows(); }
  Vector apply(const Vector& x) const override { return multiplySymmetric(A_, x); }
  std::unique_ptr<RestrictedInverse> inverseOn(const std::vector<char>& isFree, double shift) const override
  {
    NDFRAME_ASSERT(int(isFree.size()) == size(), "one flag per entry is needed");
    return std::make_unique<DenseInverse>(A_, indicesOf(isFree), shift);
  }
  const DenseMatrix* dense() const override { return &A_; }

private:
  DenseMatrix A_;
};

} // namespace

std::unique_ptr<SymmetricOperator> makeDenseOperator(DenseMatrix A)
{
  return std::make_unique<DenseOperator>(std::move(A));
}

} // namespace ndframe

#include "ndframe/algebra/symmetric_operator.hpp"

#include <utility>

#include "moved_set.hpp"
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

/// Sets that differ little from the factored one are solved from its factor (MovedSet), where factors are dear.
class DenseInverse final : public RestrictedInverse
{
public:
  DenseInverse(const DenseMatrix& A, std::vector<char> isFree, double shift)
      : indices_(indicesOf(isFree)), isFree_(std::move(isFree)), factor_(factorOf(A, indices_, shift)),
        moved_(A, factor_, placesOf(indices_, isFree_.size()), shift)
  {}
  DenseInverse(const DenseInverse&) = delete;
  DenseInverse& operator=(const DenseInverse&) = delete;

  Vector solve(const Vector& b) const override
  {
    NDFRAME_ASSERT(b.size() == isFree_.size(), "shapes do not match");
    Vector restricted(indices_.size());
    for (std::size_t i = 0; i < indices_.size(); ++i)
      restricted[i] = isFree_[std::size_t(indices_[i])] ? b[std::size_t(indices_[i])] : 0.0;
    Vector x(isFree_.size(), 0.0);
    if (moved_.isMoved())
      restricted = factor_.solveUpper(moved_.corrected(factor_.solveLower(std::move(restricted)), b, x));
    else
      restricted = factor_.solve(std::move(restricted));
    for (std::size_t i = 0; i < indices_.size(); ++i)
      if (isFree_[std::size_t(indices_[i])]) // else a zero, but for round-off
        x[std::size_t(indices_[i])] = restricted[i];
    return x;
  }

  bool moveTo(const std::vector<char>& isFree) override
  {
    constexpr int smallest = 200, rows = 8; // a factor costs as much as that of a third of its rows moved
    const auto size = int(indices_.size());
    if (size < smallest || !moved_.moveTo(isFree, size / rows))
      return false;
    isFree_ = isFree;
    return true;
  }

private:
  static std::vector<int> placesOf(const std::vector<int>& indices, std::size_t size)
  {
    std::vector<int> places(size, -1);
    for (std::size_t i = 0; i < indices.size(); ++i)
      places[std::size_t(indices[i])] = int(i);
    return places;
  }

  std::vector<int> indices_; ///< that are factored
  std::vector<char> isFree_; ///< that are solved for
  DenseCholesky factor_;
  MovedSet moved_;
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
    return std::make_unique<DenseInverse>(A_, isFree, shift);
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

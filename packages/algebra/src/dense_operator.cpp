#include "ndframe/algebra/symmetric_operator.hpp"

#include <mutex>
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

/// A factor of A_FF + shift I, which several inverses may use.
struct FactoredSet
{
  FactoredSet(const DenseMatrix& A, const std::vector<char>& set, double setShift)
      : isFree(set), shift(setShift), indices(indicesOf(isFree)), factor(factorOf(A, indices, shift))
  {}
  std::vector<char> isFree;
  double shift;
  std::vector<int> indices;
  DenseCholesky factor;
};

/// Sets that differ little from the factored one are solved from its factor (MovedSet), where factors are dear.
class DenseInverse final : public RestrictedInverse
{
public:
  DenseInverse(const DenseMatrix& A, std::shared_ptr<const FactoredSet> set)
      : set_(std::move(set)), isFree_(set_->isFree),
        moved_(A, set_->factor, placesOf(set_->indices, isFree_.size()), set_->shift)
  {}
  DenseInverse(const DenseInverse&) = delete;
  DenseInverse& operator=(const DenseInverse&) = delete;

  Vector solve(const Vector& b) const override
  {
    NDFRAME_ASSERT(b.size() == isFree_.size(), "shapes do not match");
    const auto& [factoredSet, shift, indices, factor] = *set_;
    Vector restricted(indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i)
      restricted[i] = isFree_[std::size_t(indices[i])] ? b[std::size_t(indices[i])] : 0.0;
    Vector x(isFree_.size(), 0.0);
    if (moved_.isMoved())
      restricted = factor.solveUpper(moved_.corrected(factor.solveLower(std::move(restricted)), b, x));
    else
      restricted = factor.solve(std::move(restricted));
    for (std::size_t i = 0; i < indices.size(); ++i)
      if (isFree_[std::size_t(indices[i])]) // else a zero, but for round-off
        x[std::size_t(indices[i])] = restricted[i];
    return x;
  }

  bool moveTo(const std::vector<char>& isFree) override
  {
    constexpr int smallest = 200, rows = 8; // a factor costs as much as that of a third of its rows moved
    const auto size = int(set_->indices.size());
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

  std::shared_ptr<const FactoredSet> set_;
  std::vector<char> isFree_; ///< that are solved for
  MovedSet moved_;
};

/// Keeps its last factor: the role spectrum, the Neumann problem, the iteration error and the certificate's fields ask
/// for the same set.
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
    return std::make_unique<DenseInverse>(A_, factored(isFree, shift));
  }
  const DenseMatrix* dense() const override { return &A_; }

private:
  std::shared_ptr<const FactoredSet> factored(const std::vector<char>& isFree, double shift) const
  {
    const std::lock_guard lock(mutex_);
    if (!last_ || last_->shift != shift || last_->isFree != isFree) {
      last_.reset(); // its memory serves the next one
      last_ = std::make_shared<const FactoredSet>(A_, isFree, shift);
    }
    return last_;
  }

  DenseMatrix A_;
  mutable std::mutex mutex_;
  mutable std::shared_ptr<const FactoredSet> last_;
};

} // namespace

std::unique_ptr<SymmetricOperator> makeDenseOperator(DenseMatrix A)
{
  return std::make_unique<DenseOperator>(std::move(A));
}

} // namespace ndframe

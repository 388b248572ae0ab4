#include "ndframe/interface/extended_operator.hpp"

#include <algorithm>
#include <utility>

#include "ndframe/interface/applied_operator.hpp"

namespace ndframe
{
namespace
{

/// Added to the stiffness of a motion, relative to the stiffest, so that it has an inverse.
constexpr double softest = 1e-6;

class ExtendedOperator final : public AppliedOperator
{
public:
  ExtendedOperator(std::shared_ptr<const SymmetricOperator> S, DenseMatrix R)
      : AppliedOperator(toleranceOf(*S)), S_(std::move(S)), R_(std::move(R))
  {}
  int size() const override { return R_.rows() + R_.cols(); }
  Vector apply(const Vector& x) const override { return extendedForces(S_->apply(extendedValues(x, R_)), R_); }

  bool hasPreconditioner() const override { return asApplied(*S_)->hasPreconditioner(); }

  /// diag(S, R^T S R)^-1, each as well as it is known.
  Vector precondition(const Vector& b) const override
  {
    if (!hasPreconditioner())
      return b;
    if (motionInverse_.rows() == 0)
      invertMotions();
    const auto n = std::ptrdiff_t(R_.rows());
    Vector u = asApplied(*S_)->precondition(Vector(b.begin(), b.begin() + n));
    const Vector motion = multiply(motionInverse_, Vector(b.begin() + n, b.end()));
    u.insert(u.end(), motion.begin(), motion.end());
    return u;
  }

private:
  /// (R^T S R)^-1; the unit matrix times a stiffness where S does not feel a motion.
  void invertMotions() const
  {
    DenseMatrix SR(R_.rows(), R_.cols());
    for (int m = 0; m < R_.cols(); ++m) {
      const Vector column = S_->apply(R_.column(m));
      std::copy(column.begin(), column.end(), SR.col(m));
    }
    DenseMatrix A = multiplyTransposed(R_, SR);
    double largest = 0.0;
    for (int m = 0; m < A.cols(); ++m)
      largest = std::max(largest, A(m, m));
    for (int m = 0; m < A.cols(); ++m)
      A(m, m) += largest > 0.0 ? softest * largest : 1.0;
    motionInverse_ = pseudoInverse(A, 0.0);
  }

  std::shared_ptr<const SymmetricOperator> S_;
  DenseMatrix R_;
  mutable DenseMatrix motionInverse_; ///< empty until it is needed
};

/// [S, S R; R^T S, R^T S R].
DenseMatrix extendedMatrix(const DenseMatrix& S, const DenseMatrix& R)
{
  const int n = S.rows(), modes = R.cols();
  const DenseMatrix SR = multiply(S, R), RSR = multiplyTransposed(R, SR);
  DenseMatrix A(n + modes, n + modes);
  for (int j = 0; j < n; ++j)
    std::copy_n(S.col(j), n, A.col(j));
  for (int m = 0; m < modes; ++m) {
    for (int i = 0; i < n; ++i)
      A(i, n + m) = A(n + m, i) = SR(i, m);
    std::copy_n(RSR.col(m), modes, A.col(n + m) + n);
  }
  return A;
}

} // namespace

std::shared_ptr<const SymmetricOperator> extendOperator(std::shared_ptr<const SymmetricOperator> S,
                                                        const DenseMatrix& R)
{
  if (R.cols() == 0)
    return S;
  if (const DenseMatrix* stored = S->dense())
    return makeDenseOperator(extendedMatrix(*stored, R));
  return std::make_shared<ExtendedOperator>(std::move(S), R);
}

Vector extendedValues(const Vector& unknowns, const DenseMatrix& R)
{
  Vector values = multiply(R, Vector(unknowns.begin() + R.rows(), unknowns.end()));
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] += unknowns[i];
  return values;
}

Vector extendedForces(Vector force, const DenseMatrix& R)
{
  const Vector work = multiplyTransposed(R, force);
  force.insert(force.end(), work.begin(), work.end());
  return force;
}

} // namespace ndframe

#include "ndframe/interface/extended_operator.hpp"

#include <algorithm>
#include <utility>

#include "ndframe/interface/applied_operator.hpp"

namespace ndframe
{
namespace
{

class ExtendedOperator final : public AppliedOperator
{
public:
  ExtendedOperator(std::shared_ptr<const SymmetricOperator> S, DenseMatrix R)
      : AppliedOperator(toleranceOf(*S)), S_(std::move(S)), R_(std::move(R))
  {}
  int size() const override { return R_.rows() + R_.cols(); }
  Vector apply(const Vector& x) const override { return extendedForces(S_->apply(extendedValues(x, R_)), R_); }

private:
  std::shared_ptr<const SymmetricOperator> S_;
  DenseMatrix R_;
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

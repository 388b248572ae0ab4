#pragma once

#include <memory>
#include <vector>

#include "ndframe/algebra/symmetric_operator.hpp"

namespace ndframe
{

/// An operator that is only applied; its inverses are conjugate gradients.
///
/// The relative residual goes down to `tolerance`; CG that breaks down means that A_FF is singular
/// (NotPositiveDefinite), CG that does not arrive throws NotConverged with the numbers.
class AppliedOperator : public SymmetricOperator
{
public:
  explicit AppliedOperator(double tolerance) : tolerance_(tolerance) {}
  std::unique_ptr<RestrictedInverse> inverseOn(const std::vector<char>& isFree, double shift) const override;
  const DenseMatrix* dense() const override { return nullptr; }
  double tolerance() const { return tolerance_; }

private:
  double tolerance_;
};

/// The tolerance of an operator that is only applied; 0 for a stored one.
double toleranceOf(const SymmetricOperator& S);

} // namespace ndframe

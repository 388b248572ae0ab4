#pragma once

#include <memory>
#include <vector>

#include "ndframe/algebra/symmetric_operator.hpp"

namespace ndframe
{

/// An operator that is only applied; its inverses are conjugate gradients, preconditioned where the operator knows its
/// Neumann problem: S^-1 restricted to the free entries is spectrally close to the inverse of the restriction,
/// whatever the mesh and the set. Where the set is that of the Neumann problem itself, there is nothing to iterate.
///
/// The relative residual goes down to `tolerance`; CG that breaks down means that A_FF is singular
/// (NotPositiveDefinite), CG that does not arrive throws NotConverged with the numbers.
class AppliedOperator : public SymmetricOperator
{
public:
  explicit AppliedOperator(double tolerance) : tolerance_(tolerance) {} ///< relative residual at which CG stops
  std::unique_ptr<RestrictedInverse> inverseOn(const std::vector<char>& isFree, double shift) const override;
  const DenseMatrix* dense() const override { return nullptr; }
  double tolerance() const { return tolerance_; } ///< relative residual at which CG stops

  /// An approximate inverse, symmetric and positive definite; b itself where none is known.
  virtual Vector precondition(const Vector& b) const { return b; }
  virtual bool hasPreconditioner() const { return false; } ///< precondition() is not the identity
  /// The inverse of A_FF if the operator has it without iterations; else null.
  virtual std::unique_ptr<RestrictedInverse> directInverse(const std::vector<char>& /*isFree*/) const
  {
    return nullptr;
  }

private:
  double tolerance_;
};

/// An operator that is only applied as what it is; null for a stored one.
const AppliedOperator* asApplied(const SymmetricOperator& S);

/// The tolerance of an operator that is only applied; 0 for a stored one.
double toleranceOf(const SymmetricOperator& S);

} // namespace ndframe

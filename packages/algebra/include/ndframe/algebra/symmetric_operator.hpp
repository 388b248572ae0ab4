#pragma once

#include <memory>
#include <vector>

#include "ndframe/algebra/dense.hpp"

namespace ndframe
{

/// Solves A_FF x_F = b_F for one set F; entries of the result outside F are zero.
class RestrictedInverse
{
public:
  virtual ~RestrictedInverse() = default;
  virtual Vector solve(const Vector& b) const = 0; ///< x_F for b_F, both among all rows of A
  /// Becomes the inverse of A_GG + shift I for another set G, with the shift that it has. False where a new one is
  /// cheaper, or G may be singular: then nothing has changed.
  virtual bool moveTo(const std::vector<char>& /*isFree*/) { return false; }
};

/// A symmetric positive semi-definite operator on a small replicated vector (an interface), stored or applied.
class SymmetricOperator
{
public:
  virtual ~SymmetricOperator() = default;
  virtual int size() const = 0;                    ///< rows
  virtual Vector apply(const Vector& x) const = 0; ///< A x
  /// The inverse of A_FF + shift I on the free entries (`isFree` has size(), shift >= 0). Throws NotPositiveDefinite
  /// when that is singular. The operator must outlive the inverse.
  virtual std::unique_ptr<RestrictedInverse> inverseOn(const std::vector<char>& isFree, double shift) const = 0;
  /// Forgets what earlier solutions have left to start others from: those that follow have bits of their own.
  virtual void forgetSolutions() const {}
  /// The stored matrix; null when the operator is only applied.
  virtual const DenseMatrix* dense() const = 0;
};

/// A stored dense matrix; inverses by Cholesky.
std::unique_ptr<SymmetricOperator> makeDenseOperator(DenseMatrix A);

} // namespace ndframe

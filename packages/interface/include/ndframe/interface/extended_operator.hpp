#pragma once

#include <memory>

#include "ndframe/algebra/symmetric_operator.hpp"

namespace ndframe
{

/// T^T S T on the unknowns (x, alpha), T = [I R]: the operator S in u = x + R alpha. Stored when S is stored, else
/// applied; S itself when R (S.size() x modes) has no columns.
std::shared_ptr<const SymmetricOperator> extendOperator(std::shared_ptr<const SymmetricOperator> S,
                                                        const DenseMatrix& R);

/// T (x, alpha) = x + R alpha, and T^T r = (r, R^T r).
Vector extendedValues(const Vector& unknowns, const DenseMatrix& R);
Vector extendedForces(Vector force, const DenseMatrix& R);

} // namespace ndframe

#pragma once

#include <memory>

#include "ndframe/algebra/linear_solver.hpp"
#include "ndframe/algebra/symmetric_operator.hpp"
#include "ndframe/base/registry.hpp"

namespace ndframe
{

/// How a body's Schur complement on the interface is represented.
class InterfaceOperator
{
public:
  virtual ~InterfaceOperator() = default;
  /// S of a condensed body with `size` kept dofs, in the order of the kept dofs. The body must outlive the operator,
  /// which is either stored (`dense()` shows the matrix) or an AppliedOperator.
  virtual std::unique_ptr<SymmetricOperator> represent(const CondensedBody& body, int size) const = 0;
};

/// "Automatic", "Condensed", "Matrix Free".
void registerInterfaceOperators(Registry<InterfaceOperator>& registry);

} // namespace ndframe

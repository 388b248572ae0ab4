#pragma once

#include "ndframe/interface/interface_operators.hpp"

namespace ndframe
{

void registerAutomaticOperator(Registry<InterfaceOperator>& registry);
void registerCondensedOperator(Registry<InterfaceOperator>& registry);
void registerMatrixFreeOperator(Registry<InterfaceOperator>& registry);

/// S applied by one back-solve of the body each time.
std::unique_ptr<SymmetricOperator> makeMatrixFree(const CondensedBody& body, int size, double tolerance);

/// Residual to which conjugate gradients on the interface go.
inline constexpr double interfaceTolerance = 1e-12;

} // namespace ndframe

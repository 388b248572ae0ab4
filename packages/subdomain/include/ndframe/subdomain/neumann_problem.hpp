#pragma once

#include <memory>

#include "ndframe/algebra/symmetric_operator.hpp"
#include "ndframe/base/ledger.hpp"

namespace ndframe
{

/// The Neumann problem (25) condensed to the interface:  S2 u2_N = g2 - C Lambda.
///
/// The minus is the paper's -t_neu of (52): body 2 receives the opposite of the traction on body 1. S2 must be regular,
/// that is the Neumann bodies are held by their supports.
class NeumannProblem
{
public:
  /// S must outlive the problem; g: reduced load of the Neumann bodies (force per interface unknown).
  NeumannProblem(const SymmetricOperator& S, Vector g, Ledger& ledger);

  /// u2_N under the nodal contact forces r = C Lambda (negative in compression).
  Vector solve(const Vector& contactForce) const;

private:
  Vector g_;
  std::unique_ptr<RestrictedInverse> inverse_;
  Ledger& ledger_;
};

} // namespace ndframe

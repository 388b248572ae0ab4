#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ndframe/algebra/symmetric_operator.hpp"
#include "ndframe/subdomain/status_method.hpp"

namespace ndframe
{

/// The unilateral problem (26), also with both bodies in one active set:
///
///   A u = b + r,   u_i <= bound_i,   r_i <= 0,   (u_i - bound_i) r_i = 0   for the constrained i,   r_i = 0 for the
///   others.
///
/// Solved by the status method (findStatuses). A may be singular (a floating body).
class UnilateralProblem
{
public:
  /// A must outlive the problem. rigidTraces: A.size() x modes, normal displacements of the motions that the supports
  /// leave free (no columns: A is regular). motions: their names, for messages.
  UnilateralProblem(const SymmetricOperator& A, std::vector<char> constrained, DenseMatrix rigidTraces,
                    std::vector<std::string> motions, Ledger& ledger);

  /// Throws NotConverged when the load does not press the body on what holds it (naming the free motions) or after too
  /// many passes. Where passes are kept each has a factor of its own.
  UnilateralState solve(const Vector& b, const Vector& bound, std::vector<char> closed, const PassesKept& kept = {});
  /// The next solution factors anew: its bits do not depend on those before.
  void forgetFactor() { factor_.reset(); }

private:
  class Conditions;
  bool holds(const std::vector<char>& closed) const;
  Vector applied(const Vector& x) const;
  void factor(const std::vector<char>& closed, const std::vector<char>& isFree, double shift);
  void solveClosed(const Vector& b, const Vector& bound, const std::vector<char>& closed, double shift,
                   StatusPass& pass);
  void refine(const Vector& rhs, const std::vector<char>& isFree, StatusPass& pass) const;
  double stiffnessScale() const;

  const SymmetricOperator& A_;
  std::vector<char> constrained_;
  DenseMatrix rigidTraces_;
  std::vector<std::string> motions_;
  Ledger& ledger_;
  /// The factor of the last closed set: sweeps whose statuses do not change cost no factorisation.
  std::vector<char> factoredSet_;
  double factoredShift_ = -1.0;
  std::unique_ptr<RestrictedInverse> factor_;
};

} // namespace ndframe

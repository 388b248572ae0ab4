#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ndframe/algebra/symmetric_operator.hpp"
#include "ndframe/base/ledger.hpp"

namespace ndframe
{

/// What the status method found.
struct UnilateralState
{
  Vector u;                 ///< normal displacements (all unknowns)
  Vector force;             ///< nodal contact forces r = A u - b: <= 0 where closed, 0 where open or unconstrained
  std::vector<char> closed; ///< per unknown; 0 for unconstrained ones
  int passes = 0;           ///< linear solves
  int changes = 0;          ///< statuses that differ from those at the start
  bool cycled = false;      ///< the simultaneous method came back to an earlier set; finished one node at a time
};

/// The status method for the unilateral problem (26) and for both bodies in one active set:
///
///   A u = b + r,   u_i <= bound_i,   r_i <= 0,   (u_i - bound_i) r_i = 0   for the constrained i,   r_i = 0 for the
///   others.
///
/// A primal-dual active set: closed nodes under tension open, open nodes that penetrate close, all at once, until
/// nothing changes (Hintermueller, Ito, Kunisch 2002). A set that comes back is a cycle: from then on only the first
/// violating node changes, which ends for positive definite A (Murty 1974). A may be singular (a floating body); a
/// closed set that does not hold the body is solved with a vanishing proximal term delta |u - u_prev|^2 / 2 until
/// contact holds it again. Signs and gaps are compared with round-off of the largest force and displacement, so units
/// do not matter; while nothing is closed, every penetration closes.
class UnilateralProblem
{
public:
  /// A must outlive the problem. rigidTraces: A.size() x modes, normal displacements of the motions that the supports
  /// leave free (no columns: A is regular). motions: their names, for messages.
  UnilateralProblem(const SymmetricOperator& A, std::vector<char> constrained, DenseMatrix rigidTraces,
                    std::vector<std::string> motions, Ledger& ledger);

  /// Throws NotConverged when the load does not press the body on what holds it (naming the free motions) or after too
  /// many passes.
  UnilateralState solve(const Vector& b, const Vector& bound, std::vector<char> closed);

private:
  struct Pass;
  bool holds(const std::vector<char>& closed) const;
  Vector applied(const Vector& x) const;
  void solveClosed(const Vector& b, const Vector& bound, const std::vector<char>& closed, double shift, Pass& pass);
  void refine(const Vector& rhs, const std::vector<char>& isFree, Pass& pass) const;
  std::vector<int> violations(const Vector& b, const Vector& bound, const Pass& pass,
                              const std::vector<char>& closed) const;
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

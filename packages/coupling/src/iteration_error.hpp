#pragma once

#include "motion_balance.hpp"
#include "ndframe/subdomain/neumann_problem.hpp"
#include "sweep.hpp"

namespace ndframe
{

/// The iteration's part of the error: how far, in the energy norm, the bodies are from what they would be under the
/// mean of the two tractions.
///
///   r = 1/2 C (Lambda_dir - Lambda_neu),   e^2 = r_D^T S_D^-1 r_D + r_N^T S_N^-1 r_N,
///
/// r_D and r_N the force r without its work on the free motions of the role's bodies (MotionBalance): then S^-1 has a
/// meaning, and which of its values is taken does not change e. The resultants left out are those that the other role's
/// bodies, which do not float with them, feel. No projection and no contact term is in it, so that it vanishes with the
/// iteration. While no status changes, a mode of S_D x = mu S_N x of e shrinks by |1 - theta (1 + mu)| a sweep.
class IterationError
{
public:
  /// Factors S_D; the factor of S_N is the Neumann problem's. The system and this problem must outlive it.
  IterationError(const InterfaceSystem& system, const RoleSystem& dirichlet, const RoleSystem& neumann,
                 const NeumannProblem& neumannProblem, Ledger& ledger);

  /// e of a state after a sweep, an energy norm: the square root of a work. One back-solve a role.
  double measure(const InterfaceState& state) const;

private:
  const InterfaceSystem& system_;
  MotionBalance dirichletBalance_, neumannBalance_;
  std::unique_ptr<RestrictedInverse> dirichletInverse_;
  const NeumannProblem& neumann_;
};

} // namespace ndframe

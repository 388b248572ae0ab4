#pragma once

#include "sweep.hpp"

namespace ndframe
{

/// What the Dirichlet bodies answer to the Neumann bodies' displacement.
struct DirichletStep
{
  UnilateralState status; ///< of the Dirichlet bodies, per interface unknown
  UnknownValues uNeumann; ///< u2_N with its rigid motions
  Vector motions;         ///< their amplitudes alpha
};

/// The unilateral problem (26) of the Dirichlet bodies, which also places floating Neumann bodies: their rigid motions,
/// with traces R and amplitudes alpha, are fixed by their resultants.
///
///   S1 u1 = g1 + r,   u1 - (u2 + R alpha) <= gap,   r <= 0,   product zero,   R^T r = R^T g2.
///
/// With x = u1 - R alpha this is a unilateral problem for (x, alpha) with bounds on x alone; its operator is
/// [I R]^T S1 [I R].
class DirichletProblem
{
public:
  DirichletProblem(const RoleSystem& dirichlet, const RoleSystem& neumann, Ledger& ledger);

  /// u2: a solution of the Neumann problem. Throws NotConverged when the load pulls a body off.
  DirichletStep solve(UnknownValues u2, const UnknownValues& gap, const std::vector<char>& closed);

  /// The bits of the next solution do not depend on those before.
  void forgetSolutions()
  {
    problem_.forgetFactor();
    S_->forgetSolutions();
  }

private:
  DenseMatrix R_;
  std::shared_ptr<const SymmetricOperator> S_; ///< [I R]^T S1 [I R]
  Vector b_;
  UnilateralProblem problem_;
};

} // namespace ndframe

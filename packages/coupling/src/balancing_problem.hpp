#pragma once

#include "balancing_set.hpp"

namespace ndframe
{

/// The contact of a network for one set of closed unknowns, by the displacements y that the set leaves free:
///
///   v = Z y + v_0,   A y = Z^T (g - S v_0),   A = Z^T S Z,
///
/// solved by conjugate gradients with the preconditioner of balancing domain decomposition (Mandel 1993, after the
/// Neumann-Neumann methods of De Roeck and Le Tallec 1991): residuals are shared out to the bodies by E^T, each body
/// answers with S^+ under them (a Neumann problem), answers are averaged by E = (Z^T D Z)^-1 Z^T D, D the diagonal of
/// S; the rigid motions of floating bodies, averaged, are the coarse space, in which residuals do no work. Iterations
/// are those of FETI's last pass, about; statuses have to wait for the end of each, as forces on the way balance
/// nothing.
class BalancingProblem final : public StatusSystem
{
public:
  /// The network must outlive the problem. tolerance: of the error in the energy norm, relative.
  BalancingProblem(const Network& network, double tolerance, Ledger& ledger);

  bool holds(const std::vector<char>& closed) override;
  /// proximal: 0; for sets that hold the bodies (NetworkStatuses).
  void solve(const std::vector<char>& closed, double proximal, StatusPass& pass) override;
  ProximalLimits proximalLimits() const override { return {100, 1e-6}; }
  const std::vector<std::string>& motions() const override { return motions_; }

  /// Of the last pass.
  const Vector& displacement() const { return v_; }

private:
  Vector solveSet(Vector residual);

  const Network& network_;
  double tolerance_;
  Ledger& ledger_;
  std::vector<std::string> motions_;
  NetworkBodies bodies_;
  std::unique_ptr<BalancingSet> set_;
  Vector v_;
};

} // namespace ndframe

#pragma once

#include <optional>

#include "feti_problem.hpp"

namespace ndframe
{

/// The contact of a network by a problem of its displacements (NetworkProblem, BalancingProblem), as long as every set
/// of closed unknowns holds all bodies. From the first one on that does not, by forces (FetiProblem): then bodies stay
/// where they were while loads do no work on their motions, and a pass ends early where its statuses are far from
/// right. A wall whose top is pressed on a tenth takes sixty such passes; with a proximal term, which moves bodies in
/// every one, hundreds.
template <class Held>
class NetworkStatuses final : public StatusSystem
{
public:
  /// tolerance: of the forces, where they are the unknowns. Network and problem must outlive this.
  NetworkStatuses(const Network& network, Held& held, double tolerance, Ledger& ledger)
      : network_(network), held_(held), tolerance_(tolerance), ledger_(ledger)
  {}

  bool holds(const std::vector<char>& closed) override
  {
    if (!forces_ && held_.holds(closed))
      return true;
    if (!forces_)
      forces_.emplace(network_, FetiStop{tolerance_}, ledger_);
    return forces_->holds(closed);
  }
  void solve(const std::vector<char>& closed, double proximal, StatusPass& pass) override
  {
    if (forces_)
      forces_->solve(closed, proximal, pass);
    else
      held_.solve(closed, proximal, pass);
  }
  ProximalLimits proximalLimits() const override { return held_.proximalLimits(); }
  const std::vector<std::string>& motions() const override { return held_.motions(); }

  /// Of the last pass.
  const Vector& displacement() const { return forces_ ? forces_->displacement() : held_.displacement(); }

private:
  const Network& network_;
  Held& held_;
  double tolerance_;
  Ledger& ledger_;
  std::optional<FetiProblem> forces_;
};

} // namespace ndframe

#pragma once

#include <optional>

#include "feti_problem.hpp"
#include "network_problem.hpp"

namespace ndframe
{

/// The contact of a network by sparse factors (NetworkProblem), as long as every set of closed unknowns holds all
/// bodies. From the first one on that does not, by forces (FetiProblem): then bodies stay where they were while loads
/// do no work on their motions, and a pass ends early where its statuses are far from right. A wall whose top is
/// pressed on a tenth takes sixty such passes; with a proximal term, which moves bodies in every one, hundreds.
class NetworkStatuses final : public StatusSystem
{
public:
  /// tolerance: of the forces, where they are the unknowns. The network must outlive the problem.
  NetworkStatuses(const Network& network, double tolerance, Ledger& ledger)
      : network_(network), tolerance_(tolerance), ledger_(ledger), factored_(network, ledger)
  {}

  bool holds(const std::vector<char>& closed) override
  {
    if (!forces_ && factored_.holds(closed))
      return true;
    if (!forces_)
      forces_.emplace(network_, FetiStop{tolerance_}, ledger_);
    return forces_->holds(closed);
  }
  void solve(const std::vector<char>& closed, double proximal, StatusPass& pass) override
  {
    current().solve(closed, proximal, pass);
  }
  ProximalLimits proximalLimits() const override { return factored_.proximalLimits(); }
  const std::vector<std::string>& motions() const override { return factored_.motions(); }

  /// Of the last pass.
  const Vector& displacement() const { return forces_ ? forces_->displacement() : factored_.displacement(); }

private:
  StatusSystem& current() { return forces_ ? static_cast<StatusSystem&>(*forces_) : factored_; }

  const Network& network_;
  double tolerance_;
  Ledger& ledger_;
  NetworkProblem factored_;
  std::optional<FetiProblem> forces_;
};

} // namespace ndframe

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
  /// Network and problem must outlive this.
  NetworkStatuses(const Network& network, Held& held, Ledger& ledger) : network_(network), held_(held), ledger_(ledger)
  {}

  bool holds(const std::vector<char>& closed) override
  {
    if (!forces_ && held_.holds(closed))
      return true;
    takeForces();
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
  int mostDraws() const override { return networkDraws; }
  const std::vector<std::string>& motions() const override { return held_.motions(); }
  /// Passes of `held` begin with nothing.
  StatusMemory memory() override { return forces_ ? forces_->memory() : StatusMemory(); }
  bool recall(const StatusMemory& memory) override
  {
    if (!memory.isOfForces)
      return memory.fields.empty();
    takeForces();
    return forces_->recall(memory);
  }

  /// Of the last pass.
  const Vector& displacement() const { return forces_ ? forces_->displacement() : held_.displacement(); }
  /// Null while all sets held the bodies.
  FetiProblem* forces() { return forces_ ? &*forces_ : nullptr; }

private:
  /// Of forces while statuses change: exact ones go round in circles where loose bodies lean on each other.
  static constexpr double tolerance = 1e-8;

  void takeForces()
  {
    if (!forces_)
      forces_.emplace(network_, FetiStop{tolerance}, ledger_);
  }

  const Network& network_;
  Held& held_;
  Ledger& ledger_;
  std::optional<FetiProblem> forces_;
};

/// Where a network settles.
struct SettledNetwork
{
  UnilateralState status;
  Vector v; ///< the network's displacements
};

/// The same state with forces to a smaller tolerance, and the few statuses that they change; as it was where these do
/// not settle at once.
void sharpen(FetiProblem& forces, double tolerance, const Network& network, SettledNetwork& settled);

/// The statuses of a network by NetworkStatuses, forces to the tolerance.
template <class Held>
SettledNetwork settleNetwork(const Network& network, Held& held, double tolerance, const InterfaceSystem& system,
                             const CouplingStart& start, Ledger& ledger)
{
  NetworkStatuses problem(network, held, ledger);
  SettledNetwork settled;
  settled.status = findStatuses(problem, network, system, start, ledger);
  settled.v = problem.displacement();
  if (FetiProblem* forces = problem.forces())
    sharpen(*forces, tolerance, network, settled);
  return settled;
}

} // namespace ndframe

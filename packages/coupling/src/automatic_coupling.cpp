#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "sweep.hpp"

namespace ndframe
{
namespace
{

/// Sweeps that contract by less than this (a factor of ten in some twenty) are worth their while.
constexpr double slowest = 0.9;

/// Neumann-Dirichlet where it contracts well, else all bodies in one active set.
class AutomaticCoupling final : public Coupling
{
public:
  explicit AutomaticCoupling(std::unique_ptr<Coupling> sweeps) : sweeps_(std::move(sweeps)), together_(makeMonolithic())
  {}

  Roles roles() const override { return sweeps_->roles(); }
  bool needsRoles() const override { return roles() == Roles::AsGiven; }
  bool sweeps(const InterfaceSystem& system) const override
  {
    return system.dim == 2 && system.bodies.size() <= 2 && haveRoles(system);
  }
  bool solvesWhole(int dim) const override { return dim == 3 && together_->solvesWhole(dim); }
  bool needsSpectrum() const override { return sweeps_->needsSpectrum(); }
  bool keepsSweeps() const override { return sweeps_->keepsSweeps(); }
  std::optional<double> givenTheta() const override { return sweeps_->givenTheta(); }

  CouplingResult solve(const InterfaceSystem& system, const SweepObserver& observe, Ledger& ledger,
                       const CouplingStart& start) const override
  {
    const std::string reason = againstSweeps(system, start);
    CouplingResult result = (reason.empty() ? sweeps_ : together_)->solve(system, observe, ledger, start);
    result.type = reason.empty() ? neumannDirichletName : monolithicName;
    if (!reason.empty() && !areApart(result.history.back()))
      result.reason += ", as " + reason;
    return result;
  }

private:
  /// Why sweeps would not do; empty where they would.
  std::string againstSweeps(const InterfaceSystem& system, const CouplingStart& start) const
  {
    if (system.bodies.size() > 2)
      return "there are more than two bodies";
    if (system.dim == 3)
      return "in 3D statuses settle in fewer steps than sweeps take";
    if (system.mortar)
      return "sweeps do not ask for contact in means (Pairing/Type = Mortar)";
    if (!haveRoles(system))
      return system.bodies.size() == 1 ? "a body that touches itself has no role" : "no roles suit both bodies";
    if (!start.spectrum)
      return {};
    if (!start.spectrum->isKnown())
      return "a stiffness on the interface, on which sweeps depend, is lost in round-off";
    const double theta = givenTheta().value_or(start.spectrum->bestTheta());
    const double factor = std::max(start.spectrum->contraction(theta), 1.0 - theta); // closed contact, and what opens
    return factor < slowest ? std::string() : fmt::format("sweeps would contract by {:.4g}", factor);
  }

  std::unique_ptr<Coupling> sweeps_, together_;
};

} // namespace

void registerAutomaticCoupling(Registry<Coupling>& registry, const Registry<RelaxationController>& relaxations)
{
  registerSweeps(
      registry, relaxations,
      {"Automatic",
       "Neumann-Dirichlet where its sweeps contract the error by 0.9 or better, both for closed contact and for what "
       "opens, as found from the bodies' stiffnesses on the interface before the first sweep; otherwise, with more "
       "than two bodies, and in 3D, Monolithic. The screen says which and why.",
       [](std::unique_ptr<Coupling> sweeps) { return std::make_unique<AutomaticCoupling>(std::move(sweeps)); }});
}

} // namespace ndframe

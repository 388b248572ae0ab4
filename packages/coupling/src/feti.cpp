#include <algorithm>

#include <fmt/format.h>

#include "feti_problem.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "sweep.hpp"

namespace ndframe
{
namespace
{

/// Finite element tearing and interconnecting (Farhat, Roux 1991) inside the status method: the contact forces of the
/// closed nodes by projected conjugate gradients, the motions of floating bodies by the coarse problem.
class Feti final : public Coupling
{
public:
  explicit Feti(double tolerance) : tolerance_(tolerance) {}

  Roles roles() const override { return Roles::None; }

  CouplingResult solve(const InterfaceSystem& system, const SweepObserver& observe, Ledger& ledger,
                       const CouplingStart& start) const override
  {
    needStoredOperators(system, "FETI");
    const Network network = networkOf(system);
    FetiProblem problem(network, {tolerance_, start.iterationError.value_or(0.0)}, ledger);
    if (!start.traction.empty())
      problem.startFrom(conditionForces(system, start.traction));
    const std::int64_t before = ledger.counted("FETI iterations");
    const UnilateralState status = findStatuses(problem, network, system, start, ledger);
    CouplingResult result = settled(system, stateAt(network, system, problem.displacement(), status), status,
                                    fmt::format("statuses settled in {} steps with {} iterations of FETI",
                                                status.passes, ledger.counted("FETI iterations") - before));
    result.history.back().iterationError = problem.error();
    result.contactTolerance = problem.roundOff();
    observe(result.history.back(), result.state);
    ledger.count("sweeps");
    return result;
  }

private:
  double tolerance_;
};

} // namespace

void registerFeti(Registry<Coupling>& registry)
{
  registry.add(
      "FETI",
      "The contact forces as unknowns: projected conjugate gradients with a Dirichlet preconditioner, a coarse problem "
      "of the rigid motions of floating bodies, statuses in an outer loop. Iterations grow neither with the number of "
      "bodies nor with jumps of their stiffness (Farhat and Roux 1991; docs/networks.md).",
      {{"Tolerance", 1e-12, inOpenRange(0.0, 0.1),
        "Where the iterations of a step end: residual relative to the forces, in the energy norm. With Accuracy they "
        "end where the mesh's part of the bound makes further ones useless."}},
      [](const Params& params) { return std::make_unique<Feti>(params.get<double>("Tolerance")); });
}

} // namespace ndframe

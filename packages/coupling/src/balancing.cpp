#include <fmt/format.h>

#include "balancing_problem.hpp"
#include "network_statuses.hpp"
#include "sweep.hpp"

namespace ndframe
{
namespace
{

constexpr const char* fetiCount = "FETI iterations";

/// Balancing domain decomposition inside the status method.
class NeumannNeumann final : public Coupling
{
public:
  explicit NeumannNeumann(double tolerance) : tolerance_(tolerance) {}

  Roles roles() const override { return Roles::None; }

  CouplingResult solve(const InterfaceSystem& system, const SweepObserver& observe, Ledger& ledger,
                       const CouplingStart& start) const override
  {
    needStoredOperators(system, "Neumann-Neumann");
    const Network network = networkOf(system);
    BalancingProblem balanced(network, tolerance_, ledger);
    const std::int64_t before = ledger.counted("Neumann-Neumann iterations"), fetiBefore = ledger.counted(fetiCount);
    auto [status, settledAt] = settleNetwork(network, balanced, tolerance_, system, start, ledger);
    std::string reason = fmt::format("statuses settled in {} steps with {} iterations of Neumann-Neumann",
                                     status.passes, ledger.counted("Neumann-Neumann iterations") - before);
    if (const std::int64_t ofForces = ledger.counted(fetiCount) - fetiBefore; ofForces > 0)
      reason += fmt::format(" and {} of FETI once bodies were loose", ofForces);
    const Vector v = refinedForces(network, settledAt, status, ledger);
    CouplingResult result = settled(system, stateAt(network, system, v, status), status, reason);
    observe(result.history.back(), result.state);
    ledger.count("sweeps");
    return result;
  }

private:
  double tolerance_;
};

} // namespace

void registerNeumannNeumann(Registry<Coupling>& registry)
{
  registry.add("Neumann-Neumann",
               "The displacements on the interfaces as unknowns: conjugate gradients balanced by the rigid motions of "
               "floating bodies (Mandel 1993), statuses in an outer loop. About as many iterations as FETI for one set "
               "of statuses, but every set is solved fully; from the first one on that leaves a body without enough "
               "contact the forces are the unknowns, as in FETI.",
               {{"Tolerance", 1e-12, inOpenRange(0.0, 1e-9),
                 "Where the iterations of a step end: relative error in the energy norm."}},
               [](const Params& params) { return std::make_unique<NeumannNeumann>(params.get<double>("Tolerance")); });
}

} // namespace ndframe

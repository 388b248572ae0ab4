#include <fmt/format.h>

#include "balancing_problem.hpp"
#include "feti_problem.hpp"
#include "sweep.hpp"

namespace ndframe
{
namespace
{

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
    BalancingProblem problem(network, tolerance_, ledger);
    const std::int64_t before = ledger.counted("Neumann-Neumann iterations");
    CouplingResult result;
    UnilateralState status = findStatuses(problem, std::vector<char>(network.bound.size(), 1), network.bound,
                                          firstStatuses(system, floats(system), start), ledger);
    setState(network, system, refinedForces(network, problem.displacement(), status, ledger), status, result.state);
    result.converged = true;
    result.history.push_back(recordSweep(1, system, result.state, status));
    result.reason = areApart(result.history.back())
                        ? std::string(apart)
                        : fmt::format("statuses settled in {} steps with {} iterations of Neumann-Neumann",
                                      status.passes, ledger.counted("Neumann-Neumann iterations") - before);
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
  registry.add(
      "Neumann-Neumann",
      "The displacements on the interfaces as unknowns: conjugate gradients balanced by the rigid motions of floating "
      "bodies (Mandel 1993), statuses outside. About as many iterations as FETI for one set of statuses, but every "
      "set is solved to the end.",
      {{"Tolerance", 1e-12, inOpenRange(0.0, 1e-9),
        "Where the iterations of a step end: error in the energy norm, relative."}},
      [](const Params& params) { return std::make_unique<NeumannNeumann>(params.get<double>("Tolerance")); });
}

} // namespace ndframe

#include <algorithm>

#include "ndframe/base/diagnostics.hpp"
#include "network_problem.hpp"
#include "network_statuses.hpp"
#include "sweep.hpp"
#include "whole_problem.hpp"

namespace ndframe
{
namespace
{

/// The paper's "global resolution": all bodies in one active set, no iteration between them. The result is the limit of
/// the Neumann-Dirichlet iteration on the same mesh.
class Monolithic final : public Coupling
{
public:
  Roles roles() const override { return Roles::None; }
  bool solvesWhole(int) const override { return true; }

  CouplingResult solve(const InterfaceSystem& system, const SweepObserver& observe, Ledger& ledger,
                       const CouplingStart& start) const override
  {
    const bool isWhole = areSolvedWhole(system);
    CouplingResult result = isWhole ? settleWhole(system, start, ledger) : CouplingResult();
    if (result.history.empty()) {
      InterfaceState state;
      CouplingStart again; // a run that goes on from passes of whole bodies gives them up again
      again.traction = start.traction;
      again.closed = start.closed;
      const CouplingStart& from = isWhole ? again : start;
      const UnilateralState status =
          isNetwork(system) ? solveNetwork(system, from, ledger, state) : solvePair(system, from, ledger, state);
      result = settled(system, std::move(state), status, reasonFor(system));
    }
    observe(result.history.back(), result.state);
    ledger.count("sweeps");
    return result;
  }

private:
  static const char* reasonFor(const InterfaceSystem& system)
  {
    return system.bodies.size() > 2    ? "all bodies solved together"
           : system.bodies.size() == 2 ? "both bodies solved together"
                                       : "one body, its statuses found together";
  }

  /// By iterations on whole bodies; no history where they are not solved so, or give it up.
  static CouplingResult settleWhole(const InterfaceSystem& system, const CouplingStart& start, Ledger& ledger)
  {
    try {
      WholeProblem problem(system, start);
      CouplingStart first = start;
      if (start.closed.empty() && start.fields.empty() && !start.sweeps.after)
        first.closed = problem.settleOnVertices(firstStatuses(system, floats(system), start), ledger);
      const UnilateralState status = findStatuses(problem, problem.network(), system, first, ledger);
      InterfaceState state = stateAt(problem.network(), system, problem.displacement(), status);
      const double contactTolerance = problem.roundOff();
      state.fields = std::move(problem).takeFields();
      CouplingResult result = settled(system, std::move(state), status, reasonFor(system));
      result.contactTolerance = contactTolerance;
      return result;
    } catch (const NotConverged&) {
      bool allGiveUp = true;
      for (const BodyTrace& body : system.bodies)
        allGiveUp = body.whole->givesUp() && allGiveUp;
      if (!allGiveUp)
        throw;
      return {};
    }
  }

  static bool isNetwork(const InterfaceSystem& system)
  {
    const bool areStored = std::all_of(system.bodies.begin(), system.bodies.end(),
                                       [](const BodyTrace& body) { return body.S->dense() != nullptr; });
    const bool isPair = !hasDependents(system) && !system.mortar;
    if (!areStored && !isPair)
      throw NotConverged(
          (system.mortar ? std::string("Pairing/Type = Mortar") : "a node belongs to several interfaces, which") +
          " needs stored interface operators: choose Interface Operator/Type = Condensed");
    return areStored && (system.bodies.size() > 2 || !isPair);
  }

  static UnilateralState solveNetwork(const InterfaceSystem& system, const CouplingStart& start, Ledger& ledger,
                                      InterfaceState& state)
  {
    const Network network = networkOf(system);
    NetworkProblem factored(network, ledger);
    auto [status, settled] = settleNetwork(network, factored, refinedTolerance, system, start, ledger);
    const Vector v = refinedForces(network, settled, status, ledger);
    state = stateAt(network, system, v, status);
    return std::move(status);
  }

  /// Two bodies, whatever their operators. Unknowns (w, d), w = u1_N - u2_N <= g the jump and d = u2_N (at obstacles
  /// w = u1_N <= g + their displacement, and d = 0); the energy is the sum over the bodies' condensed operators.
  static UnilateralState solvePair(const InterfaceSystem& system, const CouplingStart& start, Ledger& ledger,
                                   InterfaceState& state)
  {
    const auto n = std::size_t(system.size());
    const RoleSystem bodies = gatherJump(system);
    std::vector<char> constrained(2 * n, 0);
    std::fill_n(constrained.begin(), n, char(1));
    Vector bound(2 * n, 0.0);
    for (std::size_t i = 0; i < n; ++i)
      bound[i] = system.gap[i] + system.obstacle[i];
    UnilateralProblem problem(*bodies.S, constrained, bodies.freeMotions, bodies.motionNames, ledger);
    std::vector<char> closed = firstStatuses(system, bodies.freeMotions.cols() > 0, start);
    closed.insert(closed.end(), system.isObstacle.begin(), system.isObstacle.end());
    UnilateralState status = problem.solve(bodies.g, bound, std::move(closed), passesOf(start.sweeps));
    const auto half = std::ptrdiff_t(n);
    state.uDirichlet = state.uNeumann = ofUnknowns({status.u.begin() + half, status.u.end()});
    for (std::size_t i = 0; i < n; ++i)
      state.uDirichlet[i] += status.u[i];
    state.uNeumann = system.withObstacles(std::move(state.uNeumann));
    state.closed.assign(status.closed.begin(), status.closed.begin() + half);
    state.forceDirichlet = ofUnknowns({status.force.begin(), status.force.begin() + half});
    state.forceNeumann = state.forceDirichlet;
    state.tractionDirichlet = state.tractionNeumann = system.traction(state.forceDirichlet);
    return status;
  }
};

} // namespace

std::unique_ptr<Coupling> makeMonolithic()
{
  return std::make_unique<Monolithic>();
}

void registerMonolithic(Registry<Coupling>& registry)
{
  registry.add(
      monolithicName,
      "All bodies in one active set (the paper's global resolution): no iteration error. Any number of bodies, any "
      "number of interfaces at a node; with more than two bodies the system is sparse.",
      {}, [](const Params&) { return makeMonolithic(); });
}

} // namespace ndframe

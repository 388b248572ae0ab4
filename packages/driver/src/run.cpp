#include "ndframe/driver/run.hpp"

#include <fmt/format.h>

#include "error_checks.hpp"
#include "outputs.hpp"
#include "screen.hpp"
#include "summarize.hpp"

namespace ndframe
{
namespace
{

/// Residuals above this are a failed solve, whatever the iteration says.
constexpr double largestImbalance = 1e-6;

/// Couples the bodies; keeps the last state or, when asked, the state of every sweep. Without any state (the load pulls
/// the bodies apart) none is kept and the reason stands in the result.
void couple(Run& run, const Params& deck, const Coupling& coupling, Ledger& ledger, const Log& log)
{
  const bool keepAll = stepsNames().value(deck.sub("Output").get<std::string>("Steps")) == StepsWritten::AllSweeps;
  log.line("\n" + sweepTitle(run.model.interfaces.front(), run.model));
  {
    const auto timer = ledger.time("couple");
    const auto observe = [&](const SweepRecord& record, const InterfaceState& state) {
      log.line(sweepLine(record));
      if (keepAll)
        run.states.push_back(state);
    };
    try {
      run.coupling = coupling.solve(run.condensed.interface, observe, ledger);
      if (!keepAll)
        run.states = {run.coupling.state};
    } catch (const NotConverged& failure) {
      run.coupling.reason = failure.what();
    }
  }
  log.line(fmt::format("  {}: {}", run.coupling.converged ? "stopped" : "NOT CONVERGED", run.coupling.reason));
}

/// Why a bound that the deck wants guaranteed is not; empty when it is or need not be.
std::string missingGuarantee(const std::optional<ErrorSummary>& errors, const Params& deck)
{
  if (!errors || errors->guaranteed || !errorOptions(deck).requireGuarantee)
    return {};
  return "the bound is not guaranteed: " + errors->reason;
}

/// Why the result may not be trusted; empty when it may.
std::string failureOf(Run& run, const Params& deck)
{
  auto& coupling = run.summary.coupling;
  const double imbalance = run.summary.residuals.equilibrium;
  if (coupling && !coupling->converged)
    return "not converged: " + coupling->reason;
  if (imbalance <= largestImbalance)
    return missingGuarantee(run.summary.errors, deck);
  auto reason = fmt::format("the forces are out of balance by {:.1e}: the matrix is too ill-conditioned", imbalance);
  if (coupling) {
    coupling->converged = false;
    coupling->reason = reason;
  }
  return "not converged: " + reason;
}

Model readModel(const Params& deck, const Components& components, const Coupling& coupling, const LinearSolver& solver,
                Ledger& ledger)
{
  Diagnostics diagnostics;
  if (coupling.alternates())
    checkRoles(deck, diagnostics);
  checkErrorEstimation(deck, diagnostics);
  diagnostics.throwIfAny();
  Model model;
  {
    const auto timer = ledger.time("read");
    model = buildModel(deck, components);
  }
  const auto timer = ledger.time("check");
  checkHeld(model, deck, coupling.alternates(), diagnostics);
  checkRecovery(deck, components, model.bodies.front().mesh.dim, diagnostics);
  checkExpectationNames(outlineSummary(model, deck, solver, 1), deck, diagnostics);
  diagnostics.throwIfAny();
  return model;
}

} // namespace

Model checkDeck(const Params& deck, const Components& components, Ledger& ledger)
{
  const auto coupling = components.couplings.build(deck.sub("Coupling"));
  const auto solver = components.linearSolvers.build(deck.sub("Linear Solver"));
  return readModel(deck, components, *coupling, *solver, ledger);
}

Run runDeck(const Params& deck, const Components& components, const Comm& comm, Ledger& ledger, const Log& log)
{
  const double start = wallSeconds();
  const auto coupling = components.couplings.build(deck.sub("Coupling"));
  const auto solver = components.linearSolvers.build(deck.sub("Linear Solver"));
  const auto representation = components.interfaceOperators.build(deck.sub("Interface Operator"));
  Run run;
  run.startSeconds = start;
  run.plan = Plan(deck, *solver, comm.size());
  run.model = readModel(deck, components, *coupling, *solver, ledger);
  run.summary = outlineSummary(run.model, deck, *solver, comm.size());
  log.line(headerText(run.summary, run.model));

  run.condensed = condense(run.model, *solver, *representation, comm, ledger, log);
  if (run.plan.runs("couple"))
    couple(run, deck, *coupling, ledger, log);
  else
    run.states.emplace_back();
  if (!run.states.empty()) {
    run.fields = recoverFields(run.model, run.condensed, run.states, ledger);
    run.contact = contactNodes(run.model, run.condensed, run.coupling.state, run.fields, run.states.size() - 1);
    if (run.plan.runs("certificate"))
      run.certificate = certify(deck, components, run.model, run.condensed, run.coupling, run.fields, comm, ledger);
  }
  completeSummary(run, deck, comm);
  run.failure = failureOf(run, deck);
  copyLedger(run.summary, ledger, start);
  return run;
}

} // namespace ndframe

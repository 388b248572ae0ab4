#include "ndframe/driver/run.hpp"

#include <fmt/format.h>

#include "outputs.hpp"
#include "screen.hpp"
#include "summarize.hpp"

namespace ndframe
{
namespace
{

/// Residuals above this are a failed solve, whatever the iteration says.
constexpr double largestImbalance = 1e-6;

/// Couples the bodies; keeps the last state or, when asked, the state of every sweep.
void couple(Run& run, const Params& deck, const Coupling& coupling, Ledger& ledger, const Log& log)
{
  const bool keepAll = stepsNames().value(deck.sub("Output").get<std::string>("Steps")) == StepsWritten::AllSweeps;
  log.line("\n" + sweepTitle(run.model.interfaces.front(), run.model));
  {
    const auto timer = ledger.time("couple");
    run.coupling = coupling.solve(
        run.condensed.interface,
        [&](const SweepRecord& record, const InterfaceState& state) {
          log.line(sweepLine(record));
          if (keepAll)
            run.states.push_back(state);
        },
        ledger);
  }
  if (!keepAll)
    run.states = {run.coupling.state};
  log.line(fmt::format("  {}: {}", run.coupling.converged ? "stopped" : "NOT CONVERGED", run.coupling.reason));
}

Model readModel(const Params& deck, const Components& components, const Coupling& coupling, Ledger& ledger,
                const Log& log)
{
  Model model;
  {
    const auto timer = ledger.time("read", &log);
    model = buildModel(deck, components);
  }
  const auto timer = ledger.time("check", &log);
  Diagnostics diagnostics;
  checkHeld(model, deck, coupling.alternates(), diagnostics);
  diagnostics.throwIfAny();
  return model;
}

} // namespace

Model checkDeck(const Params& deck, const Components& components, Ledger& ledger, const Log& log)
{
  const auto coupling = components.couplings.build(deck.sub("Coupling"));
  const auto solver = components.linearSolvers.build(deck.sub("Linear Solver"));
  Model model = readModel(deck, components, *coupling, ledger, log);
  Diagnostics diagnostics;
  checkExpectationNames(outlineSummary(model, deck, *solver, 1), deck, diagnostics);
  diagnostics.throwIfAny();
  return model;
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
  run.model = checkDeck(deck, components, ledger, log);
  run.summary = outlineSummary(run.model, deck, *solver, comm.size());
  log.line(headerText(run.summary, run.model));

  run.condensed = condense(run.model, *solver, *representation, comm, ledger, log);
  if (run.plan.runs("couple"))
    couple(run, deck, *coupling, ledger, log);
  else
    run.states.emplace_back();
  run.fields = recoverFields(run.model, run.condensed, run.states, ledger, log);
  run.contact = contactNodes(run.model, run.condensed, run.coupling.state, run.fields, run.states.size() - 1);
  completeSummary(run, deck, comm);
  if (run.summary.coupling && run.summary.residuals.equilibrium > largestImbalance) {
    run.summary.coupling->converged = false;
    run.summary.coupling->reason +=
        fmt::format("; but the forces are out of balance by {:.1e}", run.summary.residuals.equilibrium);
  }
  copyLedger(run.summary, ledger, start);
  return run;
}

} // namespace ndframe

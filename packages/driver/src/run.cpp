#include "ndframe/driver/run.hpp"

#include <fmt/format.h>

#include "error_checks.hpp"
#include "ndframe/algebra/dense.hpp"
#include "ndframe/algebra/threads.hpp"
#include "outputs.hpp"
#include "roles.hpp"
#include "screen.hpp"
#include "summarize.hpp"
#include "trust.hpp"

namespace ndframe
{
namespace
{

/// Why a step could not be done, where that lies in the problem; empty when it is done.
template <class Step>
std::string failureOf(const Step& step)
{
  try {
    step();
    return {};
  } catch (const NotConverged& failure) {
    return failure.what();
  } catch (const SingularBody& failure) { // met by an iterative solver on its way
    return failure.what();
  } catch (const NotPositiveDefinite&) {
    return "a body's stiffness on the interface is lost in round-off: its matrix is too ill-conditioned";
  }
}

/// Couples the bodies; keeps the last state or, when asked, the state of every sweep.
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
    run.coupling = coupling.solve(run.condensed.interface, observe, ledger);
    if (!keepAll)
      run.states = {run.coupling.state};
  }
  log.line(fmt::format("  {}: {}", run.coupling.converged ? "stopped" : "NOT CONVERGED", run.coupling.reason));
}

/// The certificate; without one the reason stands in `failure`, and the solution is what it is.
void estimate(Run& run, const Params& deck, const Components& components, const Comm& comm, Ledger& ledger)
{
  const auto failure = failureOf([&] {
    run.certificate =
        certify(deck, components, run.model, run.condensed, run.coupling, run.fields, comm, ledger, run.reference);
  });
  if (!failure.empty())
    run.failure = "no certificate: " + failure;
}

/// Why a bound that the deck wants guaranteed is not; empty when it is or need not be.
std::string missingGuarantee(const std::optional<ErrorSummary>& errors, const Params& deck)
{
  if (!errors || errors->guaranteed || !errorOptions(deck).requireGuarantee)
    return {};
  return "the bound is not guaranteed: " + errors->reason;
}

/// A residual this many times the linear solver's tolerance is what the solver was asked for: its own is relative to
/// right-hand sides that cancel in part.
constexpr double amplification = 1e3;

/// Says that the linear solver was told to stop too early for forces in balance; empty when it was not.
std::string looseSolver(const RunSummary& summary, const Params& solver)
{
  const double imbalance = summary.residuals.equilibrium;
  const bool explains = solver.has("Tolerance") && imbalance > ResidualLimits().equilibrium &&
                        imbalance <= amplification * solver.get<double>("Tolerance");
  if (!explains)
    return {};
  return fmt::format("the forces are out of balance by {:.1e}, which results are trusted with up to {:g}: the linear "
                     "solver's Tolerance {:g} is too loose; lower it",
                     imbalance, ResidualLimits().equilibrium, solver.get<double>("Tolerance"));
}

/// Why the numbers of a solution may not be trusted; empty when they may.
std::string doubtAbout(const RunSummary& summary, const Params& deck)
{
  const auto reason = distrust(summary);
  const bool stoppedEarly = summary.coupling && !summary.coupling->converged;
  const auto loose = looseSolver(summary, deck.sub("Linear Solver"));
  return reason.empty() || stoppedEarly || loose.empty() ? reason : loose;
}

/// Says why the result may not be trusted; empty when it may. A failed check overrules an iteration that calls itself
/// converged.
std::string verdictOn(Run& run, const Params& deck)
{
  RunSummary& summary = run.summary;
  const auto reason = summary.solved ? doubtAbout(summary, deck) : run.coupling.reason;
  if (reason.empty())
    return missingGuarantee(summary.errors, deck);
  if (summary.coupling) {
    summary.coupling->converged = false;
    summary.coupling->reason = reason;
  }
  return "not converged: " + reason;
}

/// Makes an earlier (or empty) model the deck's and checks it.
void readModel(Model& model, const Params& deck, const Components& components, const Coupling& coupling,
               const LinearSolver& solver, const Comm& comm, Ledger& ledger)
{
  Diagnostics diagnostics;
  if (coupling.roles() == Roles::AsGiven)
    checkRoles(deck, diagnostics);
  checkErrorEstimation(deck, diagnostics);
  diagnostics.throwIfAny();
  updateModel(model, deck, components, comm, ledger);
  const auto timer = ledger.time("check");
  checkNumberRange(model, deck, diagnostics);
  diagnostics.throwIfAny(); // sums of such numbers mean nothing
  if (coupling.roles() == Roles::Automatic)
    giveOneRole(model, deck, diagnostics);
  checkHeld(model, deck, diagnostics);
  checkRecovery(deck, components, model.bodies.front().mesh.dim, diagnostics);
  checkExpectationNames(outlineSummary(model, deck, solver, 1), deck, diagnostics);
  diagnostics.throwIfAny();
}

/// The solution and, when asked for, its certificate. Throws what failureOf() knows when there is no solution.
void solve(Run& run, const Params& deck, const Components& components, const Coupling& coupling,
           const LinearSolver& solver, const Comm& comm, Ledger& ledger, const Log& log)
{
  const auto representation = components.interfaceOperators.build(deck.sub("Interface Operator"));
  run.condensed = condense(run.model, solver, *representation, comm, ledger, log, std::move(run.condensed));
  if (run.plan.runs("couple") && coupling.roles() == Roles::Automatic)
    chooseRoles(run, ledger, log);
  if (run.plan.runs("couple"))
    couple(run, deck, coupling, ledger, log);
  else
    run.states.emplace_back();
  run.fields = recoverFields(run.model, run.condensed, run.states, ledger);
  run.contact = contactNodes(run.model, run.condensed, run.coupling.state, run.fields, run.states.size() - 1);
  if (const auto reason = undecidedContact(run.model, run.condensed, run.coupling.state, run.fields, comm);
      !reason.empty())
  {
    run.coupling.converged = false;
    run.coupling.reason = reason;
  }
  if (run.plan.runs("certificate"))
    estimate(run, deck, components, comm, ledger);
}

/// Leaves a run without a solution; the reason stands in the coupling's result.
void giveUp(Run& run, const std::string& reason, const Log& log)
{
  run.states.clear();
  run.fields.clear();
  run.contact.clear();
  run.coupling.converged = false;
  run.coupling.reason = reason;
  log.line("  NOT CONVERGED: " + reason);
}

/// The whole run, starting with what stands in it of an earlier one.
void compute(Run& run, const Params& deck, const Components& components, const Comm& comm, Ledger& ledger,
             const Log& log)
{
  const SerialBlas serial;
  const auto coupling = components.couplings.build(deck.sub("Coupling"));
  const auto solver = components.linearSolvers.build(deck.sub("Linear Solver"));
  run.plan = Plan(deck, *solver, comm.size());
  giveBackRoles(run.model, run.condensed);
  readModel(run.model, deck, components, *coupling, *solver, comm, ledger);
  run.summary = outlineSummary(run.model, deck, *solver, comm.size());
  log.line(headerText(run.summary, run.model, coupling->roles() != Roles::Automatic));

  const auto failure = failureOf([&] { solve(run, deck, components, *coupling, *solver, comm, ledger, log); });
  if (!failure.empty())
    giveUp(run, failure, log);
  completeSummary(run, deck, comm);
  if (const std::string verdict = verdictOn(run, deck); !verdict.empty())
    run.failure = verdict;
  copyLedger(run.summary, ledger, run.startSeconds);
}

} // namespace

void checkDeck(Model& model, const Params& deck, const Components& components, const Comm& comm, Ledger& ledger)
{
  const auto coupling = components.couplings.build(deck.sub("Coupling"));
  const auto solver = components.linearSolvers.build(deck.sub("Linear Solver"));
  readModel(model, deck, components, *coupling, *solver, comm, ledger);
}

Reusable handOn(Run& run)
{
  return {std::move(run.model), std::move(run.condensed), std::move(run.reference)};
}

Run runDeck(const Params& deck, const Components& components, const Comm& comm, Ledger& ledger, const Log& log,
            Reusable&& previous)
{
  Run run;
  run.startSeconds = wallSeconds();
  run.model = std::move(previous.model);
  run.condensed = std::move(previous.condensed);
  run.reference = std::move(previous.reference);
  try {
    compute(run, deck, components, comm, ledger, log);
  } catch (...) {
    previous = handOn(run);
    throw;
  }
  return run;
}

} // namespace ndframe

#include "ndframe/driver/run.hpp"

#include "accuracy_options.hpp"
#include "adaptive_run.hpp"
#include "ndframe/algebra/threads.hpp"
#include "roles.hpp"
#include "run_steps.hpp"
#include "screen.hpp"
#include "summarize.hpp"

namespace ndframe
{
namespace
{

/// The whole run, starting with what stands in it of an earlier one.
void compute(Run& run, const RunTools& tools, const Log& log)
{
  const SerialBlas serial;
  run.plan = Plan(tools.deck, *tools.solver, tools.comm.size());
  giveBackRoles(run.model, run.condensed);
  readModel(run.model, tools);
  run.summary = outlineSummary(run.model, tools.deck, *tools.solver, tools.comm.size());
  log.line(headerText(run.summary, run.model, tools.coupling->roles() != Roles::Automatic));
  attempt(run, log, [&] {
    condenseRun(run, tools, log);
    findRoles(run, tools, log);
    solveRun(run, tools, log);
    if (run.plan.runs("certificate"))
      certifyRun(run, tools);
  });
  finishRun(run, tools);
}

} // namespace

void checkDeck(Model& model, const Params& deck, const Components& components, const Comm& comm, Ledger& ledger)
{
  const RunTools tools(deck, components, comm, ledger);
  if (wantsAccuracy(deck))
    readFirstMeshes(model, tools);
  else
    readModel(model, tools);
}

Reusable handOn(Run& run)
{
  return {std::move(run.model), std::move(run.condensed), std::move(run.reference), std::move(run.energies)};
}

Run runDeck(const Params& deck, const Components& components, const Comm& comm, Ledger& ledger, const Log& log,
            Reusable&& previous, const LevelObserver& onLevel)
{
  if (wantsAccuracy(deck))
    return runToTarget(deck, components, comm, ledger, log, onLevel, previous.energies);
  Run run;
  run.startSeconds = wallSeconds();
  run.model = std::move(previous.model);
  run.condensed = std::move(previous.condensed);
  run.reference = std::move(previous.reference);
  run.energies = std::move(previous.energies);
  try {
    compute(run, RunTools(deck, components, comm, ledger), log);
  } catch (...) {
    previous = handOn(run);
    throw;
  }
  return run;
}

} // namespace ndframe

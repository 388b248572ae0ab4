#include "ndframe/run/run_once.hpp"

#include "ndframe/algebra/threads.hpp"
#include "ndframe/condensation/roles.hpp"
#include "ndframe/run/contact_start.hpp"
#include "ndframe/run/summarize.hpp"
#include "ndframe/scene/stage.hpp"

namespace ndframe
{
namespace
{

/// The whole run, starting with what stands in it of an earlier one.
void compute(Run& run, const RunTools& tools, RunObserver& observer, const CarriedContact& contact, SweepsKept sweeps,
             SharedPasses& shared)
{
  const SerialBlas serial;
  run.plan = Plan(tools.settings, *tools.solver, tools.comm.size());
  giveBackRoles(run.model, run.condensed);
  readModel(run.model, tools);
  run.summary = outlineSummary(run.model, tools.settings, *tools.solver, tools.comm.size());
  observer.header(run.summary, run.model, tools.coupling->roles() != Roles::Automatic);
  attempt(run, observer, [&] {
    condenseRun(run, tools, observer);
    findRoles(run, tools, observer);
    CouplingStart start = startLike(run, contact);
    start.sweeps = sharedPasses(std::move(sweeps), run.model, shared, tools.comm);
    solveRun(run, tools, observer, std::move(start));
    if (run.plan.runs(Stage::Certificate))
      certifyRun(run, tools);
  });
  finishRun(run, tools);
}

} // namespace

Reusable handOn(Run& run)
{
  return {std::move(run.model), std::move(run.condensed), std::move(run.reference), std::move(run.energies)};
}

Run runOnce(const RunTools& tools, RunObserver& observer, Reusable&& previous, SweepsKept sweeps, SharedPasses& shared)
{
  Run run;
  run.startSeconds = wallSeconds();
  run.model = std::move(previous.model);
  run.condensed = std::move(previous.condensed);
  run.reference = std::move(previous.reference);
  run.energies = std::move(previous.energies);
  try {
    compute(run, tools, observer, previous.contact, std::move(sweeps), shared);
  } catch (...) {
    previous = handOn(run);
    throw;
  }
  return run;
}

Run runOnce(const RunTools& tools, RunObserver& observer, Reusable&& previous)
{
  SharedPasses none;
  return runOnce(tools, observer, std::move(previous), {}, none);
}

} // namespace ndframe

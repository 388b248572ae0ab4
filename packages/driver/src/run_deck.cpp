#include "ndframe/driver/run_deck.hpp"

#include "accuracy_list.hpp"
#include "error_list.hpp"
#include "ndframe/accuracy/adaptive_run.hpp"
#include "ndframe/accuracy/first_meshes.hpp"
#include "ndframe/report/screen_observer.hpp"
#include "ndframe/run/run_once.hpp"

namespace ndframe
{
namespace
{

/// Refuses lists of the deck that contradict each other; all that needs no mesh.
void checkLists(const RunTools& tools, const Components& components)
{
  Diagnostics diagnostics;
  if (tools.coupling->roles() == Roles::AsGiven)
    checkRoles(tools.deck, diagnostics);
  checkErrorEstimation(tools.settings.errors, tools.settings.output, diagnostics);
  checkAccuracy(tools.settings, components, diagnostics);
  diagnostics.throwIfAny();
}

} // namespace

void checkDeck(Model& model, const RunSettings& settings, const Components& components, const Comm& comm,
               Ledger& ledger)
{
  const RunTools tools(settings, components, comm, ledger);
  checkLists(tools, components);
  if (settings.accuracy)
    readFirstMeshes(model, tools, components);
  else
    readModel(model, tools);
}

Run runDeck(const RunSettings& settings, const Components& components, const Comm& comm, Ledger& ledger, const Log& log,
            Reusable&& previous, const LevelObserver& onLevel)
{
  RunTools tools(settings, components, comm, ledger);
  checkLists(tools, components);
  ScreenObserver screen(log);
  if (settings.accuracy)
    return runToTarget(std::move(tools), components, screen, onLevel, previous.energies);
  return runOnce(tools, screen, std::move(previous));
}

Run runDeck(const Params& deck, const Components& components, const Comm& comm, Ledger& ledger, const Log& log,
            Reusable&& previous, const LevelObserver& onLevel)
{
  return runDeck(readSettings(deck), components, comm, ledger, log, std::move(previous), onLevel);
}

} // namespace ndframe

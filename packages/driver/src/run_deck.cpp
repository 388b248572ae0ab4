#include "ndframe/driver/run_deck.hpp"

#include "ndframe/accuracy/accuracy_list.hpp"
#include "ndframe/accuracy/adaptive_run.hpp"
#include "ndframe/accuracy/first_meshes.hpp"
#include "ndframe/certification/error_checks.hpp"
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
  checkErrorEstimation(tools.deck, diagnostics);
  checkAccuracy(tools.deck, components, diagnostics);
  diagnostics.throwIfAny();
}

} // namespace

void checkDeck(Model& model, const Params& deck, const Components& components, const Comm& comm, Ledger& ledger)
{
  const RunTools tools(deck, components, comm, ledger);
  checkLists(tools, components);
  if (wantsAccuracy(deck))
    readFirstMeshes(model, tools, components);
  else
    readModel(model, tools);
}

Run runDeck(const Params& deck, const Components& components, const Comm& comm, Ledger& ledger, const Log& log,
            Reusable&& previous, const LevelObserver& onLevel)
{
  RunTools tools(deck, components, comm, ledger);
  checkLists(tools, components);
  ScreenObserver screen(log);
  if (wantsAccuracy(deck))
    return runToTarget(std::move(tools), components, screen, onLevel, previous.energies);
  return runOnce(tools, screen, std::move(previous));
}

} // namespace ndframe

#include "ndframe/driver/run_deck.hpp"

#include "accuracy_list.hpp"
#include "automatic_list.hpp"
#include "error_list.hpp"
#include "found_interfaces.hpp"
#include "ndframe/accuracy/adaptive_run.hpp"
#include "ndframe/accuracy/first_meshes.hpp"
#include "ndframe/condensation/roles.hpp"
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
    checkRoles(tools.settings.scene, diagnostics);
  checkErrorEstimation(tools.settings.errors, tools.settings.output, diagnostics);
  checkAccuracy(tools.settings, components, diagnostics);
  checkCheckpoint(tools.settings, *tools.coupling, diagnostics);
  diagnostics.throwIfAny();
}

/// A model with nothing but the meshes of one.
Model meshesOf(Model&& model)
{
  model.interfaces.clear();
  model.recipe.interfaces.clear();
  return std::move(model);
}

} // namespace

RunSettings checkDeck(Model& model, const RunSettings& given, const Components& components, const Comm& comm,
                      Ledger& ledger, const Log& log)
{
  RunSettings settings = withFoundInterfaces(given, components, model, comm, ledger, log);
  const RunTools tools(settings, components, comm, ledger);
  checkLists(tools, components);
  if (settings.accuracy)
    readFirstMeshes(model, tools, components);
  else
    readModel(model, tools);
  return settings;
}

Run runDeck(const RunSettings& given, const Components& components, const Comm& comm, Ledger& ledger, const Log& log,
            Reusable&& previous, const LevelObserver& onLevel, const Restart& restart)
{
  giveBackRoles(previous.model, previous.condensed);
  const RunSettings settings = withFoundInterfaces(given, components, previous.model, comm, ledger, log);
  RunTools tools(settings, components, comm, ledger);
  checkLists(tools, components);
  ScreenObserver screen(log);
  if (settings.accuracy)
    return runToTarget(std::move(tools), components, screen, onLevel, previous.energies,
                       findsInterfaces(given.deck) ? meshesOf(std::move(previous.model)) : Model(), restart);
  SharedPasses shared = restart.from ? restart.from->shared : SharedPasses();
  return runOnce(tools, screen, std::move(previous), sweepsOf(restart, settings, shared), shared);
}

Run runDeck(const Params& deck, const Components& components, const Comm& comm, Ledger& ledger, const Log& log,
            Reusable&& previous, const LevelObserver& onLevel)
{
  return runDeck(readSettings(deck), components, comm, ledger, log, std::move(previous), onLevel);
}

} // namespace ndframe

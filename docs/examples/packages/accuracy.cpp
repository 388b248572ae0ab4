// Refines the meshes of a scene until the guaranteed bound is below 2 %, and writes down the bounds on the way.
#include <cmath>

#include "ndframe/accuracy/adaptive_run.hpp"
#include "ndframe/accuracy/level_errors.hpp"
#include "ndframe/base/deck.hpp"
#include "ndframe/driver/deck_spec.hpp"
#include "ndframe/driver/settings.hpp"
#include "ndframe/driver/tied_deck.hpp"

int main()
{
  using namespace ndframe;
  const auto components = makeComponents();
  DeckList list = parseDeck(defaultDeck(), "default"); // a unit block on another one, which is clamped; E = 1
  Diagnostics mistakes;
  for (const char* setting : {"Bodies/upper/Material/Poisson Ratio=0", "Bodies/lower/Material/Poisson Ratio=0",
                              "Bodies/upper/Loads/press/Value=1", "Bodies/upper/Loads/weight/Type=Body Force",
                              "Bodies/upper/Loads/weight/Y=-1", "Discretization/Order=1", "Accuracy/Target=0.02",
                              "Error Estimation/Estimators={Global}"})
    applySetting(list, setting, mistakes);
  const RunSettings settings = readSettings(validateScene(list, makeDeckSpec(*components), mistakes));
  mistakes.throwIfAny();

  const Comm comm = Comm::single();
  Ledger ledger;
  RunObserver observer; // takes no notice
  std::vector<double> bounds;
  const auto note = [&](const Run& run, int) { bounds.push_back(LevelErrors(run, *settings.accuracy).relative); };
  const Run run = runToTarget(RunTools(settings, *components, comm, ledger), *components, observer, note);

  // Stresses -(2 - y) above and -2 below: a(u, u) = 7/3 + 4, and |u - u_h|^2 is what a(u_h, u_h) is less than that.
  const double error = std::sqrt((19.0 / 3.0 - run.summary.energy) / run.summary.energy);
  const AccuracySummary& levels = *run.summary.accuracy;
  const bool ok = levels.reached && bounds.size() > 1 && bounds.size() == levels.levels.size() &&
                  bounds.back() <= 0.02 && bounds.front() > 0.02 && error <= bounds.back();
  return ok ? 0 : 1;
}

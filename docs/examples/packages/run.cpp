// Runs a deck, and again with twice the load: the second run takes over meshes and factors of the first one.
#include <cmath>

#include "ndframe/base/deck.hpp"
#include "ndframe/driver/deck_spec.hpp"
#include "ndframe/driver/settings.hpp"
#include "ndframe/driver/tied_deck.hpp"
#include "ndframe/run/run_once.hpp"

int main()
{
  using namespace ndframe;
  const auto components = makeComponents();
  const Comm comm = Comm::single();
  Ledger ledger;        // one for both: the factors count in it
  RunObserver observer; // takes no notice of what the steps tell
  const auto runWith = [&](const std::string& pressure, Reusable&& previous) {
    DeckList deck = parseDeck(defaultDeck(), "default"); // a unit block on another one, which is clamped; E = 1
    Diagnostics mistakes;
    for (const char* body : {"upper", "lower"})
      applySetting(deck, std::string("Bodies/") + body + "/Material/Poisson Ratio=0", mistakes);
    applySetting(deck, "Bodies/upper/Loads/press/Value=" + pressure, mistakes);
    applySetting(deck, "Coupling/Type=Monolithic", mistakes); // no iteration: the answer is exact
    const RunSettings settings = readSettings(validateScene(deck, makeDeckSpec(*components), mistakes));
    mistakes.throwIfAny();
    return runOnce(RunTools(settings, *components, comm, ledger), observer, std::move(previous));
  };
  Run first = runWith("0.01", {});
  const double energy = first.summary.energy;
  const std::int64_t factorisations = ledger.counted("factorisations");
  const Run second = runWith("0.02", handOn(first));

  // Each block becomes shorter by p / E and stores p^2 / E.
  const bool ok = second.failure.empty() && std::abs(energy - 2e-4) < 1e-14 &&
                  std::abs(second.summary.energy - 8e-4) < 1e-14 &&
                  std::abs(second.summary.bodies[0].displacement.value - 0.04) < 1e-12 && factorisations == 2 &&
                  ledger.counted("factorisations") == 2;
  return ok ? 0 : 1;
}

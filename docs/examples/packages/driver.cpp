// Reads a deck, changes it as --set does, runs it and reads the result from the summary.
#include <cmath>

#include "ndframe/base/deck.hpp"
#include "ndframe/driver/deck_spec.hpp"
#include "ndframe/driver/run_deck.hpp"
#include "ndframe/driver/tied_deck.hpp"
#include "ndframe/report/summary_text.hpp"

int main()
{
  using namespace ndframe;
  const auto components = makeComponents();
  DeckList deck = parseDeck(defaultDeck(), "default"); // two unit blocks, the upper one pressed down; or readDeck(path)
  Diagnostics mistakes;
  applySetting(deck, "Bodies/upper/Loads/press/Value=0.02*x", mistakes);
  const Params params = validateScene(deck, makeDeckSpec(*components), mistakes);
  mistakes.throwIfAny(); // all of them at once, each with its place in the deck

  Ledger ledger;
  const Run run = runDeck(params, *components, Comm::single(), ledger, silentLog());
  // Contact hands the load on, int 0.02 x dx = 0.01, and the ground carries it.
  const auto contact = summaryValue(run.summary, "interfaces/contact/contact_force");
  const double ground = run.summary.bodies[1].supports[0].force[1];
  const bool ok = run.failure.empty() && contact && std::abs(*contact - 0.01) < 1e-9 && std::abs(ground - 0.01) < 1e-9;
  return ok ? 0 : 1;
}

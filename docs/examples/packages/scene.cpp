// Builds the scene of a deck and finds how a body can still move, and whether its load pulls it off.
#include <cmath>

#include "ndframe/base/deck.hpp"
#include "ndframe/driver/deck_spec.hpp"
#include "ndframe/driver/tied_deck.hpp"
#include "ndframe/scene/rigid_check.hpp"

int main()
{
  using namespace ndframe;
  const auto components = makeComponents();
  DeckList deck = parseDeck(defaultDeck(), "default"); // a unit block on another, clamped one; x = 0 is a symmetry
  Diagnostics mistakes;
  applySetting(deck, "Bodies/upper/Loads/press/Value=-0.01", mistakes); // pulled, not pressed
  const Params params = validateScene(deck, makeDeckSpec(*components), mistakes);
  mistakes.throwIfAny();
  const Model model =
      buildModel(readScene(params), *components); // meshes, nodes, pairs of contact; nothing is assembled

  double force = 0.0;
  model.loads[0].each([&](int /*node*/, const double* values) { force += values[1]; }); // along y
  bool pulledOff = false;
  try {
    refusePulledOff(model);
  } catch (const NotConverged&) {
    pulledOff = true; // the message says which bodies move, and how
  }
  // Up and down is free but for contact; 8 edges of second order on either side of the interface.
  const bool ok = model.freeMotions[0].cols() == 1 && model.freeMotions[1].cols() == 0 &&
                  model.interfaces[0].numNodes() == 17 && std::abs(force - 0.01) < 1e-15 && pulledOff;
  return ok ? 0 : 1;
}

#include "drawn_trial.hpp"

#include "accuracy_list.hpp"
#include "ndframe/driver/deck_spec.hpp"
#include "ndframe/driver/run_deck.hpp"
#include "ndframe/driver/tied_deck.hpp"

namespace ndframe
{

std::vector<Diagnostic> mistakesOfDeck(const std::string& deck, const std::string& file, const Components& components)
{
  try {
    Diagnostics diagnostics;
    DeckList input = parseDeck(deck, file);
    completeAccuracyDeck(input, diagnostics);
    const Params params = validateScene(input, makeDeckSpec(components), diagnostics);
    diagnostics.throwIfAny();
    Ledger ledger;
    Model model;
    checkDeck(model, readSettings(params), components, Comm::single(), ledger);
  } catch (const InputError& error) {
    return error.list();
  }
  return {};
}

} // namespace ndframe

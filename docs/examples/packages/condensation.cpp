// Condenses two blocks to the sides that touch, finds the contact forces there and recovers the displacements.
#include <cmath>

#include "ndframe/base/deck.hpp"
#include "ndframe/condensation/reactions.hpp"
#include "ndframe/driver/deck_spec.hpp"
#include "ndframe/driver/tied_deck.hpp"

int main()
{
  using namespace ndframe;
  const auto components = makeComponents();
  DeckList list = parseDeck(defaultDeck(), "default"); // a unit block is pressed by 0.01 on another, clamped one
  Diagnostics mistakes;
  applySetting(list, "Coupling/Type=Monolithic", mistakes);
  const Params deck = validateScene(list, makeDeckSpec(*components), mistakes);
  mistakes.throwIfAny();

  const Comm comm = Comm::single();
  Ledger ledger;
  const Model model = buildModel(readScene(deck), *components);
  const auto solver = components->linearSolvers.build(deck.sub("Linear Solver"));
  const auto representation = components->interfaceOperators.build(deck.sub("Interface Operator"));
  const CondensedModel condensed = condense(model, *solver, *representation, comm, ledger);
  const auto coupling = components->couplings.build(deck.sub("Coupling"));
  const InterfaceState state = coupling
                                   ->solve(
                                       condensed.interface, [](auto&, auto&) {}, ledger)
                                   .state;
  const auto fields = recoverFields(model, condensed, {state}, comm, ledger); // of all bodies, per state

  const auto contact = contactNodes(model, condensed, state, fields, 0);
  const ResidualSummary residual = residuals(model, condensed, state, fields, contact, comm);
  const Vector forces = supportForces(model, condensed, state, 1, fields[1]);
  const SupportSummary ground = supportReactions(model.bodies[1], forces, comm)[0];
  // The clamp carries what is pressed, and the blocks are in equilibrium.
  const bool ok = std::abs(ground.force[1] - 0.01) < 1e-13 && residual.equilibrium < 1e-10 &&
                  residual.penetration < 1e-10 && ledger.counted("factorisations") == 2;
  return ok ? 0 : 1;
}

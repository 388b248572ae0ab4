// Certifies a solution on a mesh that is too coarse for it: the bound holds for the error, which is known here.
#include <cmath>

#include "ndframe/base/deck.hpp"
#include "ndframe/certification/certificate.hpp"
#include "ndframe/driver/deck_spec.hpp"
#include "ndframe/driver/settings.hpp"
#include "ndframe/driver/tied_deck.hpp"

int main()
{
  using namespace ndframe;
  const auto components = makeComponents();
  DeckList list = parseDeck(defaultDeck(), "default"); // a unit block on another one, which is clamped; E = 1
  Diagnostics mistakes;
  for (const char* setting :
       {"Bodies/upper/Material/Poisson Ratio=0", "Bodies/lower/Material/Poisson Ratio=0", "Discretization/Order=1",
        "Bodies/upper/Loads/press/Value=1", "Bodies/upper/Loads/weight/Type=Body Force",
        "Bodies/upper/Loads/weight/Y=-1", "Coupling/Type=Monolithic", "Error Estimation/Estimators={Global}"})
    applySetting(list, setting, mistakes);
  const Params deck = validateScene(list, makeDeckSpec(*components), mistakes);
  mistakes.throwIfAny();

  const Comm comm = Comm::single();
  Ledger ledger;
  const RunSettings settings = readSettings(deck);
  const Model model = buildModel(settings.scene, *components);
  const auto solver = components->linearSolvers.build(deck.sub("Linear Solver"));
  const auto representation = components->interfaceOperators.build(deck.sub("Interface Operator"));
  const CondensedModel condensed = condense(model, *solver, *representation, comm, ledger);
  const SweepObserver silent = [](const SweepRecord&, const InterfaceState&) {};
  const auto coupling = components->couplings.build(deck.sub("Coupling"))->solve(condensed.interface, silent, ledger);
  const auto fields = recoverFields(model, condensed, {coupling.state}, comm, ledger);
  std::shared_ptr<const ReferenceSolution> reference; // none is asked for
  const Certificate certificate = certify(settings.scene, *settings.errors, *components, model, condensed, coupling,
                                          fields, comm, ledger, reference);

  // Stresses -(2 - y) above and -2 below: a(u, u) = 7/3 + 4 = -2 E(u), and |u - u_h|^2 = a(u, u) - a(u_h, u_h).
  const double exact = 19.0 / 3.0;
  const ErrorMeasureSummary& bound = *certificate.summary.global;
  const double error = std::sqrt(exact - std::pow(bound.absolute / bound.relative, 2));
  const bool ok = certificate.summary.guaranteed && bound.absolute >= error && bound.absolute < 2.0 * error &&
                  certificate.energy->lower <= -0.5 * exact && certificate.energy->upper >= -0.5 * exact;
  return ok ? 0 : 1;
}

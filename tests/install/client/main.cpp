// A program of another project with a relaxation controller of its own: client DECK.

#include <iostream>

#include "ndframe/driver/components.hpp"
#include "ndframe/driver/deck_spec.hpp"

namespace
{

using namespace ndframe;

/// theta_p = 1 / p: the traction becomes the mean of all that the Dirichlet body answered.
class Averaging final : public RelaxationController
{
public:
  explicit Averaging(int firstSweep) : firstSweep_(firstSweep) {}
  void start() override { sweep_ = firstSweep_; }
  RelaxedTraction next(const Vector& dirichlet, const Vector& neumann) override
  {
    const double theta = 1.0 / sweep_++;
    return {relax(dirichlet, neumann, theta), theta, {}};
  }

private:
  int firstSweep_;
  int sweep_ = 1;
};

void registerAveraging(Components& components)
{
  components.relaxations.add(
      "Averaging", "Mean of all answers.", {{"First Sweep", 1, atLeast(1), "Number of the first sweep."}},
      [](const Params& params) { return std::make_unique<Averaging>(params.get<int>("First Sweep")); });
}

} // namespace

int main(int argc, char** argv)
{
  if (argc != 2)
    return 2;
  const auto components = makeComponents(registerAveraging);
  Diagnostics diagnostics;
  const auto deck = validate(readDeck(argv[1]), makeDeckSpec(*components), diagnostics);
  diagnostics.throwIfAny();
  const auto controller = components->relaxations.build(deck.sub("Coupling").sub("Relaxation"));
  controller->start();
  const auto theta = controller->next({1.0}, {0.0}).theta;
  std::cout << "first theta of the deck's relaxation: " << theta << '\n';
  return theta == 0.25 ? 0 : 1;
}

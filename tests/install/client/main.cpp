// A program of another project: ndframe with a relaxation controller of its own.

#include "ndframe/driver/main.hpp"

namespace
{

using namespace ndframe;

/// theta_p = 1 / p: the traction becomes the mean of all that the Dirichlet body answered.
class Averaging final : public RelaxationController
{
public:
  explicit Averaging(int firstSweep) : firstSweep_(firstSweep), sweep_(firstSweep) {}
  void start() override { sweep_ = firstSweep_; }
  RelaxedTraction next(const Vector& dirichlet, const Vector& neumann) override
  {
    const double theta = 1.0 / sweep_++;
    return {relax(dirichlet, neumann, theta), theta, {}};
  }

private:
  int firstSweep_, sweep_;
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
  return ndframe::runMain(argc, argv, registerAveraging);
}

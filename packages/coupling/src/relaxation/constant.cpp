#include "relaxations.hpp"

namespace ndframe
{
namespace
{

/// A fixed factor, as in the paper's examples.
///
/// Converges for 0 < theta < theta*, where theta* < 2 falls with the ratio of the Dirichlet to the Neumann body's
/// stiffness.
class Constant final : public RelaxationController
{
public:
  explicit Constant(double theta) : theta_(theta) {}
  void start() override {}
  std::optional<double> givenTheta() const override { return theta_; }
  RelaxedTraction next(const InterfaceValues& dirichlet, const InterfaceValues& neumann) override
  {
    return {relax(dirichlet, neumann, theta_), theta_, {}};
  }
  RelaxationMemory memory() const override { return {}; }
  bool recall(const RelaxationMemory& memory) override { return memory.empty(); }

private:
  double theta_;
};

} // namespace

void registerConstant(Registry<RelaxationController>& registry)
{
  registry.add("Constant", "The same factor in every sweep.",
               {{"Theta", 0.5, inOpenRange(0.0, 2.0), "Relaxation factor theta of equation (27) of the paper."}},
               [](const Params& p) { return std::make_unique<Constant>(p.get<double>("Theta")); });
}

} // namespace ndframe

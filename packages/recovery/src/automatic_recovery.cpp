#include "automatic_recovery.hpp"

#include <algorithm>
#include <cmath>

#include "global_recovery.hpp"
#include "star_recovery.hpp"

namespace ndframe
{
namespace
{

/// Half the gain a sweep, which costs some five steps more on well-shaped cells.
DescentEnd endWith(int sweeps)
{
  const double most = std::min(1e6, usualEnd.most * (1.0 + sweeps));
  return {int(most), std::ldexp(usualEnd.leastGain, -sweeps)};
}

class AutomaticRecovery final : public StressRecovery
{
public:
  AutomaticRecovery(int degree, int sweeps)
      : plane_(makeStarRecovery(degree, sweeps)), space_(makeGlobalRecovery(degree, endWith(sweeps)))
  {}

  std::vector<SceneStress> recover(const RecoveryScene& scene, const std::vector<SceneField>& fields, const Comm& comm,
                                   Ledger& ledger) const override
  {
    return chosen(scene.bodies.front()->mesh.dim).recover(scene, fields, comm, ledger);
  }
  int degree(int order) const override { return plane_->degree(order); }
  bool optimises(int dim) const override { return chosen(dim).optimises(dim); }
  bool settles(int dim) const override { return chosen(dim).settles(dim); }
  std::string refusal(int dim, int order, bool optimise) const override
  {
    return chosen(dim).refusal(dim, order, optimise);
  }
  std::string standsFor(int dim) const override { return dim == 2 ? "Star" : "Global"; }

private:
  const StressRecovery& chosen(int dim) const { return dim == 2 ? *plane_ : *space_; }

  std::unique_ptr<StressRecovery> plane_, space_;
};

} // namespace

void registerAutomaticRecovery(Registry<StressRecovery>& registry)
{
  registry.add(
      "Automatic", "Star in 2D, Global in 3D.",
      {{"Degree", 0, inClosedRange(0, 3),
        "Degree of the stresses: the order of the displacements or one more; 0 means the order."},
       {"Sweeps", 0, atLeast(0),
        "Makes the bound lower: sweeps over the stars in 2D; in 3D each halves the Least Gain of Global (0.01) and "
        "lets it take 100 more steps."}},
      [](const Params& p) { return std::make_unique<AutomaticRecovery>(p.get<int>("Degree"), p.get<int>("Sweeps")); });
}

} // namespace ndframe

#include "sweep.hpp"

namespace ndframe
{

void registerCouplings(Registry<Coupling>& registry, const Registry<RelaxationController>& relaxations)
{
  registerAutomaticCoupling(registry, relaxations);
  registerNeumannDirichlet(registry, relaxations);
  registerMonolithic(registry);
  registerFeti(registry);
  registerNeumannNeumann(registry);
}

} // namespace ndframe

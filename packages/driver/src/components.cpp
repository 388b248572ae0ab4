#include "ndframe/driver/components.hpp"
#include "ndframe/iterative/linear_solvers.hpp"

#include "ndframe/scene/tied_mesh.hpp"

namespace ndframe
{

std::unique_ptr<Components> makeComponents(const Extension& extend)
{
  auto components = std::make_unique<Components>();
  registerMeshSources(components->meshSources);
  registerTied(components->meshSources);
  registerMaterials(components->materials);
  registerSupports(components->supports);
  registerLoads(components->loads);
  registerObstacles(components->obstacles);
  registerLinearSolvers(components->linearSolvers);
  registerInterfaceOperators(components->interfaceOperators);
  registerRelaxations(components->relaxations);
  registerRecoveries(components->recoveries);
  registerMarkings(components->markings);
  registerRefinements(components->refinements);
  registerContactTransfers(components->contactTransfers);
  registerLevelStoppings(components->levelStoppings);
  if (extend)
    extend(*components);
  registerCouplings(components->couplings, components->relaxations);
  return components;
}

} // namespace ndframe

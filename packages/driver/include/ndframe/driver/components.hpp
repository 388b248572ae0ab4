#pragma once

#include <functional>
#include <memory>

#include "ndframe/adaptivity/marking.hpp"
#include "ndframe/adaptivity/refinement.hpp"
#include "ndframe/algebra/linear_solver.hpp"
#include "ndframe/assembly/side_condition.hpp"
#include "ndframe/coupling/coupling.hpp"
#include "ndframe/coupling/level_stopping.hpp"
#include "ndframe/interface/contact_transfer.hpp"
#include "ndframe/interface/interface_operators.hpp"
#include "ndframe/mechanics/material_law.hpp"
#include "ndframe/meshing/mesh_source.hpp"
#include "ndframe/recovery/stress_recovery.hpp"

namespace ndframe
{

/// All components a deck can name. Builders keep references between registries: the object stays where it was made.
struct Components
{
  Registry<MeshSource> meshSources{"mesh"};
  Registry<MaterialLaw> materials{"material", "Isotropic"};
  Registry<Support> supports{"support"};
  Registry<Load> loads{"load"};
  Registry<LinearSolver> linearSolvers{"linear solver", "Automatic"};
  Registry<InterfaceOperator> interfaceOperators{"interface operator", "Automatic"};
  Registry<RelaxationController> relaxations{"relaxation", "Automatic"};
  Registry<Coupling> couplings{"coupling", "Automatic"};
  Registry<StressRecovery> recoveries{"recovery", "Star"};
  Registry<Marking> markings{"marking", "Predicted"};
  Registry<Refinement> refinements{"refinement", "Bisection"};
  Registry<ContactTransfer> contactTransfers{"transfer", "Carried"};
  Registry<LevelStopping> levelStoppings{"level stopping", "Balanced"};

  Components() = default;
  Components(const Components&) = delete;
  Components& operator=(const Components&) = delete;
};

/// Adds components of another project: called before those that build on others (couplings use relaxations).
using Extension = std::function<void(Components&)>;

/// Registers everything that ndframe ships, and the extension's components.
std::unique_ptr<Components> makeComponents(const Extension& extend = {});

} // namespace ndframe

#pragma once

#include "ndframe/algebra/linear_solver.hpp"
#include "ndframe/coupling/coupling.hpp"
#include "ndframe/interface/interface_operators.hpp"

namespace ndframe
{

/// What solves scenes.
struct SolverComponents
{
  Registry<LinearSolver> linearSolvers{"linear solver", "Automatic"};
  Registry<InterfaceOperator> interfaceOperators{"interface operator", "Automatic"};
  Registry<RelaxationController> relaxations{"relaxation", "Automatic"};
  Registry<Coupling> couplings{"coupling", "Automatic"};
};

} // namespace ndframe

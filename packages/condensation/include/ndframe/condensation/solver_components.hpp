#pragma once

#include "ndframe/algebra/linear_solver.hpp"
#include "ndframe/coupling/coupling.hpp"
#include "ndframe/interface/interface_operators.hpp"

namespace ndframe
{

/// What solves scenes.
struct SolverComponents
{
  Registry<LinearSolver> linearSolvers{"linear solver", "Automatic"};                ///< list Linear Solver
  Registry<InterfaceOperator> interfaceOperators{"interface operator", "Automatic"}; ///< list Interface Operator
  Registry<RelaxationController> relaxations{"relaxation", "Automatic"};             ///< list Coupling/Relaxation
  Registry<Coupling> couplings{"coupling", "Automatic"};                             ///< list Coupling
};

} // namespace ndframe

#pragma once

#include <vector>

#include "ndframe/algebra/comm.hpp"
#include "solver_problem.hpp"

namespace ndframe
{

/// The order in which a direct solver eliminates the free dofs: METIS nested dissection of the graph of the nodes with
/// interior dofs, each node expanded to its interior dofs (a graph dim^2 times smaller than that of the dofs); then the
/// kept dofs in the order of SolverProblem::kept, so that their Schur complement is the factor's last block.
///
/// Returns position -> free number on rank 0, nothing on the other ranks. Collective. Timed as the stage "order".
std::vector<int> eliminationOrder(const SolverProblem& problem, const FreeDofs& free, const Comm& comm, Ledger& ledger);

} // namespace ndframe

#pragma once

#include <vector>

#include "ndframe/algebra/comm.hpp"
#include "ndframe/algebra/solver_problem.hpp"
#include "node_graph.hpp"

namespace ndframe
{

/// The graph of the nodes with interior dofs. Rank 0 gets the whole graph, the others an empty one. Collective.
NodeGraph interiorGraph(const SolverProblem& problem, const Comm& comm);

/// The nodes in the order of METIS's nested dissection. One thread at a time: others wait.
std::vector<int> nestedDissection(NodeGraph graph);

/// The same for the graph without its dominated vertices, which are eliminated just before their hosts.
std::vector<int> reducedDissection(const NodeGraph& graph);

/// Position -> free number: the nodes' interior dofs, then the kept dofs.
std::vector<int> freeOrder(const SolverProblem& problem, const FreeDofs& free, const std::vector<int>& nodes);

/// The order in which a direct solver eliminates the free dofs: METIS nested dissection of the graph of the nodes with
/// interior dofs (dim^2 times smaller than that of the dofs) but the dominated ones, which follow their hosts; each
/// node expanded to its interior dofs; then the kept dofs in the order of SolverProblem::kept, so that their Schur
/// complement is the factor's last block.
///
/// Returns position -> free number on rank 0, nothing on the other ranks. Collective. Timed as the stage "order".
std::vector<int> eliminationOrder(const SolverProblem& problem, const FreeDofs& free, const Comm& comm, Ledger& ledger);

} // namespace ndframe

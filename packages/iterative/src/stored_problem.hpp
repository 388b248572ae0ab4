#pragma once

#include "ndframe/algebra/linear_solver.hpp"

namespace ndframe
{

/// The problem without the rigid motions and points of middles of edges and of other ranks: where there are edge nodes,
/// nearNullSpace and nodePoints then have rows of this rank's own vertices only, ascending. This is what LinearLevel
/// reads, and it takes an eighth of a rank's share of the memory on solids.
SolverProblem withOwnVertices(const SolverProblem& given);

/// The same problem again: rigid motions and points are linear along the edges. Collective.
SolverProblem withAllNodes(SolverProblem problem, const Comm& comm);

} // namespace ndframe

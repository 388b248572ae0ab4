#pragma once

#include "ndframe/algebra/linear_solver.hpp"

namespace ndframe
{

/// The problem without the rigid motions and points of middles of edges: where there are edge nodes, nearNullSpace and
/// nodePoints then have rows of vertices only, in their order. This is what LinearLevel reads, and it takes an eighth
/// of the memory on solids.
SolverProblem withVerticesOnly(const SolverProblem& given);

/// The same problem again: rigid motions and points are linear along the edges.
SolverProblem withAllNodes(SolverProblem problem);

} // namespace ndframe

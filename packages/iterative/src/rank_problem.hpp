#pragma once

#include "ndframe/algebra/rank_problem.hpp"

namespace ndframe
{

/// What this rank holds of a problem. hasEdges: whether functions are linear between vertices somewhere; else all nodes
/// count as vertices.
RankProblem heldPart(const SolverProblem& problem, bool hasEdges);

/// The same with its kept dofs in this role.
RankProblem withKeptDofsAs(DofRole role, RankProblem problem);

/// The problem on all ranks again, for a solver that needs it so: rigid motions and points are linear along the edges.
/// Collective.
SolverProblem onAllRanks(const RankProblem& problem, const Comm& comm);

} // namespace ndframe

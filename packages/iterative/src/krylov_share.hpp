#pragma once

#include "krylov_body.hpp"
#include "ndframe/algebra/rank_problem.hpp"

namespace ndframe
{

/// A body that no rank has as a whole: it can be joined to others (WholeSolver::join), and nothing else.
/// problem: with its kept dofs as Kept. description: what the conjugate gradients are.
std::unique_ptr<CondensedBody> makeKrylovShare(RankProblem problem, const Comm& comm, Ledger& ledger,
                                               KrylovOptions options, MakeJoinedGradients makeJoined,
                                               std::string description);

} // namespace ndframe

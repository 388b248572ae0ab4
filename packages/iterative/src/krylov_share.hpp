#pragma once

#include "krylov_body.hpp"
#include "ndframe/algebra/rank_problem.hpp"

namespace ndframe
{

/// A body that no rank has as a whole: a WholeSolver, which is joined to others or solved by itself, and nothing else.
/// problem: with its kept dofs as Kept. description: what the conjugate gradients are.
std::unique_ptr<CondensedBody> makeKrylovShare(RankProblem problem, const Comm& comm, Ledger& ledger,
                                               KrylovOptions options, MakeConjugateGradients makeCg,
                                               MakeJoinedGradients makeJoined, std::string description);

} // namespace ndframe

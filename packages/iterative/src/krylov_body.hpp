#pragma once

#include <functional>
#include <memory>

#include "ndframe/algebra/linear_solver.hpp"
#include "ndframe/iterative/krylov_library.hpp"

namespace ndframe
{

struct KrylovOptions
{
  double tolerance;
  int maxIterations;
};

/// Sets up conjugate gradients for a problem with its matrix; `decoupledDiagonal`: a typical entry of the diagonal.
using MakeConjugateGradients = std::function<std::unique_ptr<ConjugateGradients>(
    const RankProblem& problem, const Comm& comm, double decoupledDiagonal)>;

/// Sets up conjugate gradients on several bodies; null where there are none.
using MakeJoinedGradients = std::function<std::unique_ptr<JoinedGradients>(
    const JoinedBodies& bodies, const JoinedUnknowns& unknowns, const Comm& comm)>;

/// A body whose back-solves are runs of conjugate gradients. Nothing is factored; the Schur complement takes a run per
/// kept dof. `description`: what the conjugate gradients are. Counts "Krylov solves" and "Krylov iterations", and where
/// there are two levels "fine products", "multigrid cycles" and "multigrid set-ups", on several ranks also "halo
/// messages" and "halo bytes": what all ranks send to each other in products and cycles, MueLu's with its default
/// smoothers.
std::unique_ptr<CondensedBody> makeKrylovBody(SolverProblem problem, const Comm& comm, Ledger& ledger,
                                              KrylovOptions options, MakeConjugateGradients makeCg,
                                              MakeJoinedGradients makeJoined, std::string description);

} // namespace ndframe

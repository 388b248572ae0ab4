#pragma once

#include "krylov_body.hpp"
#include "ndframe/algebra/joined_system.hpp"

namespace ndframe
{

/// Problems with their kept dofs freed, as one system. Counts "Krylov solves", "Krylov iterations", "fine products",
/// "multigrid cycles", "multigrid set-ups", on the vertices "vertex iterations", "vertex products" and "vertex cycles",
/// and "halo messages" and "halo bytes". The problems must outlive it.
/// largestEigenvalue: on return that of D^-1 K with all kept dofs free.
std::unique_ptr<JoinedSystem> makeJoinedKrylov(const std::vector<const RankProblem*>& problems, const JoinedRows& open,
                                               const Comm& comm, Ledger& ledger, KrylovOptions options,
                                               const MakeJoinedGradients& make, double& largestEigenvalue);

/// The same of bodies, which are told this eigenvalue: WholeSolver::join().
std::unique_ptr<JoinedSystem> joinBodies(const std::vector<const WholeSolver*>& bodies, const JoinedRows& open,
                                         const Comm& comm, Ledger& ledger, KrylovOptions options,
                                         const MakeJoinedGradients& make);

} // namespace ndframe

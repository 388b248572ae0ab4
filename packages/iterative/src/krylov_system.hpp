#pragma once

#include "cycle_count.hpp"
#include "krylov_body.hpp"
#include "ndframe/algebra/joined_system.hpp"
#include "ndframe/algebra/shared_values.hpp"
#include "recycled_solutions.hpp"

namespace ndframe
{

/// K on the dofs of one role, solved by conjugate gradients from a start that earlier solutions give. Vectors have the
/// dofs of the rank's own nodes.
class KrylovSystem
{
public:
  /// Collective.
  KrylovSystem(const RankProblem& problem, const Comm& comm, Ledger& ledger, KrylovOptions options,
               const MakeConjugateGradients& makeCg, bool hasTwoLevels);

  /// Improves u, whose kept and fixed values are given, until the true residual is small beside the first, or beside
  /// the reference if that is larger, or round-off. Throws NotConverged and SingularBody. Collective.
  Vector solve(const Vector& load, const Vector& u, double reference = 0.0,
               Exactness exactness = Exactness::Full) const;

  void forgetSolutions() const { recycled_ = RecycledSolutions(comm_); }

private:
  void add(const Vector& own, Vector& held) const;
  void fetchGhosts(Vector& held) const;
  Vector interiorResidual(const Vector& load, const Vector& held) const;
  CycleWork work() const;

  const BlockMatrix& matrix_;
  std::vector<char> isInterior_; ///< per own dof
  SharedValues ghosts_;
  Comm comm_;
  Ledger& ledger_;
  KrylovOptions options_;
  std::unique_ptr<ConjugateGradients> cg_;
  mutable RecycledSolutions recycled_;
  mutable CycleCount work_;
};

} // namespace ndframe

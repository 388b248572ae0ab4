#pragma once

#include <vector>

#include "ndframe/algebra/neumann_solver.hpp"

namespace ndframe
{

/// What the factored bodies share: the split into interior and kept dofs, and what follows from expand() alone.
class SplitBody : public CondensedBody, public NeumannSolver
{
public:
  /// g = load_c - (K u)_c with u = expand(load, 0).
  DenseMatrix reduce(const DenseMatrix& load) const override;
  /// S u_c = (K u)_c with u = expand(0, u_c).
  Vector applySchur(const Vector& kept) const override;
  const FreeMotions& freeMotions() const override { return motions_; } ///< found by the constructor, with `held`

protected:
  /// Collective. The matrix of the problem and the ledger must outlive it.
  SplitBody(const SolverProblem& problem, const Comm& comm, Ledger& ledger);

  int numDofs() const { return matrix_.numDofs(); } ///< fixed ones included
  int numKept() const { return int(kept_.size()); } ///< n_c
  /// Asserts the shapes of an expansion's arguments.
  void checkShapes(const DenseMatrix& load, const DenseMatrix& kept) const;
  /// (K u)_c for all columns of u; collective.
  DenseMatrix keptRowsTimes(const DenseMatrix& u) const;

  const BlockMatrix& matrix_; ///< K, this rank's rows
  std::vector<int> kept_;     ///< dofs, in the order of the condensed system
  FreeMotions motions_;       ///< that the fixed dofs leave
  Comm comm_;                 ///< the ranks that share K
  Ledger& ledger_;            ///< counts what the body does; not owned
};

} // namespace ndframe

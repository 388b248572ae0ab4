#pragma once

#include <vector>

#include "ndframe/algebra/linear_solver.hpp"

namespace ndframe
{

/// The rigid motions that a body's fixed dofs leave free, as its kept dofs see them.
struct FreeMotions
{
  DenseMatrix traces;    ///< n_c x motions; no columns: the fixed dofs hold the body
  std::vector<int> held; ///< as many kept dofs (their positions) that hold it, so that none of the motions is left
};

/// What every condensed body can do besides: the Neumann problem K u = r with the kept dofs free and forces r on them
/// only, seen at the kept dofs, S u_c = r. From the factor or by one run of conjugate gradients on K, never through S.
///
/// Counts "kept solves" in the ledger where the factor's block of the kept dofs is enough, at a cost of n_c^2; else
/// "back-solves".
class NeumannSolver
{
public:
  virtual ~NeumannSolver() = default;

  /// Where the body has free motions, u_c vanishes at freeMotions().held and the equations hold elsewhere; there too if
  /// r balances, traces^T r = 0. Only if solvesNeumann().
  virtual Vector solveNeumann(const Vector& force) const = 0;

  /// False when K with the held dofs is singular all the same: unconnected parts, a mechanism.
  virtual bool solvesNeumann() const = 0;

  virtual const FreeMotions& freeMotions() const = 0; ///< found when the body was factored
};

/// The Neumann solver that every body of a LinearSolver is.
const NeumannSolver& neumannSolver(const CondensedBody& body);

} // namespace ndframe

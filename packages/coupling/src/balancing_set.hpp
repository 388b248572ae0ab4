#pragma once

#include "averages.hpp"
#include "ndframe/algebra/sparse_cholesky.hpp"
#include "ndframe/algebra/sparse_columns.hpp"
#include "network_bodies.hpp"

namespace ndframe
{

/// One set of closed unknowns for balancing domain decomposition (BalancingProblem has the equations): the bodies'
/// displacements v = Z y + v_0 that meet it, A = Z^T S Z and the parts of its preconditioner.
class BalancingSet
{
public:
  /// Network and bodies must outlive it.
  BalancingSet(const Network& network, const NetworkBodies& bodies, const std::vector<char>& closed);

  bool isOf(const std::vector<char>& closed) const { return closed == closed_; }
  /// Whether supports and closed unknowns stop all motions.
  bool holds() const { return bodies_.numMotions() == 0 || coarse_ != nullptr; }
  const ClosedRows& rows() const { return rows_; }

  /// A y.
  Vector product(const Vector& y) const;
  /// C (C^T A C)^-1 C^T r, C = E R: the displacements by motions of the bodies that take r's work on them away.
  Vector balanced(const Vector& r) const;
  /// (1 - C (C^T A C)^-1 C^T A) E S^+ E^T r for an r that does no work on C.
  Vector preconditioned(const Vector& r) const;

private:
  void factorCoarse();
  SparseRow product(const SparseRow& column, SparseSum& entries, SparseSum& free) const;

  const Network& network_;
  const NetworkBodies& bodies_;
  std::vector<char> closed_;
  ClosedRows rows_;
  std::vector<SparseRow> inFree_, entries_; ///< Z by entries of v, and Z^T
  Averages average_;                        ///< E = (Z^T D Z)^-1 Z^T D
  SparseColumns C_, AC_;                    ///< C = E R
  std::unique_ptr<SparseCholesky> coarse_;  ///< of C^T A C
};

} // namespace ndframe

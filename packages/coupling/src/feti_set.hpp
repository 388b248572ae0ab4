#pragma once

#include "feti_bodies.hpp"
#include "ndframe/algebra/sparse_cholesky.hpp"
#include "ndframe/algebra/sparse_columns.hpp"

namespace ndframe
{

/// B, the preconditioner M and the coarse problem of FETI for one set of closed unknowns (FetiProblem has the
/// equations). Vectors of forces and jumps have its rows: the closed unknowns that do not follow from others.
class FetiSet
{
public:
  /// Network and bodies must outlive it.
  FetiSet(const Network& network, const FetiBodies& bodies, const std::vector<char>& closed);

  const std::vector<int>& rows() const { return rows_; } ///< unknowns
  bool isOf(const std::vector<char>& closed) const { return closed == closed_; }
  /// Whether the rows stop all motions, if there are any: then the coarse problem has a factor.
  bool holdsMotions() const { return bodies_.numMotions() == 0 || projects(); }
  bool projects() const { return coarse_ != nullptr; }

  /// B v and B^T r.
  Vector jump(const Vector& v) const;
  Vector pushed(const Vector& r) const;
  /// M w = B_D S_A B_D^T w.
  Vector preconditioned(const Vector& w) const;
  /// G r.
  Vector work(const Vector& r) const { return G_.transposedTimes(r); }
  /// Q G^T (G Q G^T)^-1 x: forces that do the work x on the motions.
  Vector balancing(const Vector& x) const { return QG_.times(coarse_->solve(x)); }
  /// P r = r - Q G^T (G Q G^T)^-1 G r, and P^T w; all of r and w without coarse problem.
  Vector projected(Vector r) const;
  Vector projectedTransposed(Vector w) const;
  /// The amplitudes a with G^T a nearest to w in the norm of Q.
  Vector amplitudes(const Vector& w) const { return coarse_->solve(QG_.transposedTimes(w)); }

private:
  void weighRows();
  void condenseBodies();
  void factorCoarse();
  Vector scaled(const Vector& w) const;
  Vector stiffOnClosed(std::size_t body, const Vector& v) const;

  const Network& network_;
  const FetiBodies& bodies_;
  std::vector<int> rows_;
  std::vector<char> closed_, touched_; ///< touched: entries of v that stand in rows
  std::unique_ptr<SparseCholesky> gram_, coarse_;
  Vector gramDiagonal_;
  SparseColumns G_, QG_; ///< G^T, Q G^T: rows x motions
  std::vector<std::vector<int>> open_;
  std::vector<std::unique_ptr<DenseCholesky>> openFactor_;
};

} // namespace ndframe

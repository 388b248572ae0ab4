#pragma once

#include "averages.hpp"
#include "ndframe/algebra/sparse_cholesky.hpp"
#include "ndframe/algebra/sparse_columns.hpp"
#include "network_bodies.hpp"

namespace ndframe
{

/// B, the preconditioner M and the coarse problem of FETI for one set of closed unknowns (FetiProblem has the
/// equations). Vectors of forces and jumps have its rows: the closed unknowns that do not follow from others.
class FetiSet
{
public:
  /// Network and bodies must outlive it. before: whose bodies' factors are taken where the same entries are open.
  FetiSet(const Network& network, const NetworkBodies& bodies, const std::vector<char>& closed, const FetiSet* before);

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
  /// A body's stiffness on its open entries, which S_A eliminates.
  struct OpenPart
  {
    std::vector<int> entries;
    std::shared_ptr<const DenseCholesky> factor; ///< null without entries
  };
  void condenseBodies(const FetiSet* before);
  DenseMatrix stiffnessOn(std::size_t body, const std::vector<int>& entries) const;
  void findOpenings();
  void factorCoarse();
  SparseRow scaled(const SparseRow& openings, SparseSum& entries, SparseSum& rows) const;
  Vector stiffOnClosed(std::size_t body, const Vector& v) const;

  const Network& network_;
  const NetworkBodies& bodies_;
  std::vector<int> rows_;
  std::vector<char> closed_;
  Averages weighted_;                          ///< B_D
  std::vector<SparseRow> users_, spreadUsers_; ///< B^T and B_D^T
  std::vector<OpenPart> open_;                 ///< per body
  SparseColumns G_, QG_;                       ///< G^T, Q G^T: rows x motions
  std::unique_ptr<SparseCholesky> coarse_;
};

} // namespace ndframe

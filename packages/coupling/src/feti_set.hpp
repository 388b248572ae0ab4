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
  /// Whether the rows stop all motions, if there are any.
  bool holdsMotions() const { return !isLoose_; }
  /// Whether forces on the rows can do the work x on the motions, whatever the rows leave free.
  bool canBalance(const Vector& x) const;
  /// Whether the coarse problem is used: not with a proximal term, which motions feel.
  void project(bool isUsed) { projects_ = isUsed && coarse_ != nullptr; }
  bool projects() const { return projects_; }

  /// B v and B^T r.
  Vector jump(const Vector& v) const;
  Vector pushed(const Vector& r) const;
  /// M w = B_D S_A B_D^T w.
  Vector preconditioned(const Vector& w) const;
  /// G r.
  Vector work(const Vector& r) const { return G_.transposedTimes(r); }
  /// Q G^T (G Q G^T)^-1 x: forces that do the work x on the motions.
  Vector balancing(const Vector& x) const { return QG_.times(solveCoarse(x)); }
  /// P r = r - Q G^T (G Q G^T)^-1 G r, and P^T w; all of r and w without coarse problem.
  Vector projected(Vector r) const;
  Vector projectedTransposed(Vector w) const;
  /// The amplitudes a with G^T a nearest to w in the norm of Q; where the rows leave motions free, those of `before`.
  Vector amplitudes(const Vector& w, const Vector& before) const;

private:
  /// A body's stiffness on its open entries, which S_A eliminates.
  struct OpenPart
  {
    std::vector<int> entries;
    std::shared_ptr<const DenseCholesky> factor; ///< null without entries
  };
  void condenseBodies(const FetiSet* before);
  DenseMatrix stiffnessOn(std::size_t body, const std::vector<int>& entries) const;
  void factorCoarse();
  void holdLoosely(SymmetricEntries coarse);
  Vector solveCoarse(const Vector& x) const;
  SparseRow scaled(const SparseRow& openings, SparseSum& entries, SparseSum& rows) const;
  Vector stiffOnClosed(std::size_t body, const Vector& v) const;

  const Network& network_;
  const NetworkBodies& bodies_;
  std::vector<int> rows_;
  std::vector<char> closed_;
  Averages weighted_;                          ///< B_D
  std::vector<SparseRow> users_, spreadUsers_; ///< B^T and B_D^T
  std::vector<OpenPart> open_;                 ///< per body
  SparseColumns G_, QG_;                       ///< G^T, what the motions open, and Q G^T: rows x motions
  std::unique_ptr<SparseCholesky> coarse_;
  Vector springs_; ///< added to the diagonal of the coarse problem where rows leave motions free
  bool isLoose_ = false, projects_ = false;
};

} // namespace ndframe

#pragma once

#include <vector>

#include "ndframe/algebra/comm.hpp"
#include "ndframe/algebra/rank_problem.hpp"
#include "ndframe/algebra/sparse_field.hpp"

namespace ndframe
{

/// The entries at the dofs of this rank's rows of a vector of all dofs, and such a vector from the entries of all
/// ranks.
Vector ownPart(const BlockMatrix& K, const Vector& all);
Vector gathered(const BlockMatrix& K, const double* own, const Comm& comm); ///< own: of all rows. Collective

/// K u in this rank's rows; u at the nodes that it holds.
Vector ownProduct(const BlockMatrix& K, const Vector& held);
Vector ownSizes(const BlockMatrix& K, const Vector& held); ///< |K| |u|, the moduli of the entries
double normOf(const Vector& own, const Comm& comm);        ///< of all ranks. Collective
/// Mean of the diagonal over all rows of all ranks, a scale for springs and tolerances. Collective.
double meanDiagonal(const BlockMatrix& K, const Comm& comm);

/// The dofs of this rank's nodes, those of one body after those of another, and where the kept dofs of all bodies are
/// among them. Only kept values are on all ranks.
class OwnDofs
{
public:
  /// problems: with the kept dofs as interior ones, -1 among them where one is none of these; they must outlive it.
  OwnDofs(const std::vector<const RankProblem*>& problems, const Comm& comm);

  std::size_t size() const { return isFree_.size(); }
  /// Free and no kept dof.
  bool isInside(std::size_t own) const { return isFree_[own] && !isKept_[own]; }

  /// Of loads, per body; zero on dofs that are not free.
  Vector part(const std::vector<const SparseField*>& loads) const;
  Vector part(const std::vector<NodalField>& fields) const; ///< of values at own nodes; the same
  std::vector<NodalField> fields(const Vector& own) const;  ///< per body, at own nodes
  /// Per kept dof of all bodies, on all ranks. Collective.
  Vector atKept(const Vector& own) const;
  void setKept(const Vector& kept, Vector& own) const; ///< kept: on all ranks
  double norm(const Vector& own) const;                ///< of all ranks. Collective

private:
  const std::vector<const RankProblem*> problems_;
  Comm comm_;
  std::vector<char> isFree_, isKept_; ///< per own dof
  std::vector<int> place_;            ///< per kept dof among the own ones; -1: another rank's
};

} // namespace ndframe

#pragma once

#include "krylov_body.hpp"
#include "own_dofs.hpp"

namespace ndframe
{

/// The equations of a JoinedSystem, on all nodes or on the vertices: u, how its kept dofs follow unknowns, and how
/// conjugate gradients improve it.
class JoinedEquations
{
public:
  /// problems: with the kept dofs as interior ones, -1 among them where one is none of these (a place that no rows
  /// speak of); they must outlive it.
  JoinedEquations(std::vector<const RankProblem*> problems, const Comm& comm);

  /// Numbers of the kept dofs among those of all bodies, -1 where one is none.
  const std::vector<RankProblem::Global>& keptNumbers() const { return numbers_; }
  const OwnDofs& own() const { return own_; }

  /// springs: a multiple of the diagonal at the unknowns. Collective.
  JoinedUnknowns unknowns(const JoinedRows& rows, double springs) const;
  /// From now on.
  void follow(const JoinedUnknowns& unknowns, FollowingGradients& gradients);
  void begin(Vector u) { u_ = std::move(u); } ///< u: at own dofs
  const Vector& u() const { return u_; }      ///< at own dofs

  /// JoinedSystem::solve(); load: at own dofs. Adds the iterations.
  Vector improve(const Vector& load, Vector& kept, double tolerance, int maxIterations,
                 const FollowingGradients& gradients, const Ledger& ledger, int& iterations);

private:
  Vector diagonal(const JoinedRows& rows) const;
  Vector unbalanced(const Vector& load, const FollowingGradients& gradients) const;
  Vector reduced(const Vector& rest, const Vector& kept, const Vector& centre) const;
  void add(const Vector& x, Vector& kept);

  std::vector<const RankProblem*> problems_;
  Comm comm_;
  OwnDofs own_;
  std::vector<RankProblem::Global> numbers_;
  std::vector<std::pair<int, RankProblem::Global>> kept_; ///< body and its dof
  JoinedRows rows_;
  Vector springs_; ///< per kept dof; empty: none
  Vector u_;
};

} // namespace ndframe

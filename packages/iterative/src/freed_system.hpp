#pragma once

#include "krylov_body.hpp"
#include "krylov_system.hpp"

namespace ndframe
{

/// A body with its kept dofs as unknowns, but for those that hold it: what WholeSolver asks for. The conjugate
/// gradients are set up when they are first needed.
class FreedSystem
{
public:
  /// problem: with the kept dofs as interior ones.
  FreedSystem(RankProblem problem, const Comm& comm, Ledger& ledger, KrylovOptions options,
              MakeConjugateGradients makeCg, bool hasTwoLevels)
      : problem_(std::move(problem)), comm_(comm), ledger_(ledger), options_(options), makeCg_(std::move(makeCg)),
        hasTwoLevels_(hasTwoLevels)
  {}

  const RankProblem& problem() const { return problem_; }
  void dropProblem() { problem_ = {}; } ///< where nothing is asked for any more
  /// WholeSolver::solveFree(). Throws NotConverged and SingularBody. Collective, as is the set-up.
  NodalField solve(const NodalField& load, const NodalField& start, Exactness exactness) const;
  void forget() const { system_.reset(); } ///< gives back what the set-up made
  void forgetSolutions() const;
  /// Of D^-1 K: Chebyshev's polynomials take it until a solve shows that it is too small.
  void setLargestEigenvalue(double value) const { largestEigenvalue_ = value; }

private:
  const KrylovSystem& system() const;

  RankProblem problem_;
  Comm comm_;
  Ledger& ledger_;
  KrylovOptions options_;
  MakeConjugateGradients makeCg_;
  bool hasTwoLevels_;
  mutable std::unique_ptr<KrylovSystem> system_;
  mutable double largestEigenvalue_ = 0.0;
};

} // namespace ndframe

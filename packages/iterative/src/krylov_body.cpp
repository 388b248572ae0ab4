#include "krylov_body.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "freed_system.hpp"
#include "joined_krylov.hpp"
#include "ndframe/algebra/split_body.hpp"
#include "own_dofs.hpp"
#include "rank_problem.hpp"

namespace ndframe
{

namespace
{

RankProblem freedPart(const SolverProblem& problem, const FreeMotions& motions, bool hasEdges)
{
  RankProblem freed = withKeptDofsAs(DofRole::Interior, heldPart(problem, hasEdges));
  freed.holding = motions.held;
  return freed;
}

/// Nothing is factored: every back-solve is a run of conjugate gradients, and the Schur complement takes one per kept
/// dof.
class KrylovBody final : public SplitBody, public WholeSolver
{
public:
  KrylovBody(SolverProblem problem, const Comm& comm, Ledger& ledger, KrylovOptions options,
             MakeConjugateGradients makeCg, MakeJoinedGradients makeJoined, std::string description)
      : SplitBody(problem, comm, ledger), freed_(freedPart(problem, motions_, makeJoined != nullptr), comm, ledger,
                                                 options, makeCg, makeJoined != nullptr),
        options_(options), makeCg_(std::move(makeCg)), makeJoined_(std::move(makeJoined)),
        description_(std::move(description))
  {
    problem = {}; // as large as all nodes
    if (kept_.empty()) {
      interior();
      freed_.dropProblem();
    }
  }

  DenseMatrix expand(const DenseMatrix& load, const DenseMatrix& kept) const override
  {
    checkShapes(load, kept);
    DenseMatrix u(numDofs(), load.cols());
    for (int j = 0; j < u.cols(); ++j) {
      Vector start(std::size_t(matrix_.numRows()) * std::size_t(matrix_.dim), 0.0);
      for (int c = 0; c < numKept(); ++c)
        if (const int own = ownDof(c); own >= 0)
          start[std::size_t(own)] = kept(c, j);
      const Vector own = interior().solve(ownPart(matrix_, load.column(j)), start);
      const Vector solution = gathered(matrix_, own.data(), comm_);
      std::copy(solution.begin(), solution.end(), u.col(j));
    }
    return u;
  }

  Vector solveNeumann(const Vector& force) const override
  {
    if (kept_.empty())
      return {};
    NodalField load(matrix_.nodes.withoutGhosts(), matrix_.dim);
    for (int c = 0; c < numKept(); ++c)
      if (const int own = ownDof(c); own >= 0)
        load[std::size_t(own)] = force[std::size_t(c)];
    const NodalField u = solveFree(load, NodalField(load.map(), load.width()), Exactness::Full);
    Vector kept(force.size(), 0.0);
    for (int c = 0; c < numKept(); ++c)
      if (const int own = ownDof(c); own >= 0)
        kept[std::size_t(c)] = u[std::size_t(own)];
    comm_.sum(kept);
    return kept;
  }

  bool solvesNeumann() const override { return true; }

  NodalField solveFree(const NodalField& load, NodalField start, Exactness exactness) const override
  {
    return freed_.solve(load, start, exactness);
  }

  void forget() const override { freed_.forget(); }

  void forgetSolutions() const override
  {
    freed_.forgetSolutions();
    if (interior_)
      interior_->forgetSolutions();
  }

  void setLargestEigenvalue(double value) const override { freed_.setLargestEigenvalue(value); }

  bool solvesWhole() const override { return makeJoined_ != nullptr; }
  const RankProblem& freedProblem() const override { return freed_.problem(); }

  std::unique_ptr<JoinedSystem> join(const std::vector<const WholeSolver*>& bodies,
                                     const JoinedRows& open) const override
  {
    startMpi();
    return joinBodies(bodies, open, comm_, ledger_, options_, makeJoined_);
  }

  DenseMatrix schurComplement() const override
  {
    const int n = numKept();
    DenseMatrix S(n, n);
    for (int j = 0; j < n; ++j) {
      Vector unit(std::size_t(n), 0.0);
      unit[std::size_t(j)] = 1.0;
      const Vector column = applySchur(unit);
      std::copy(column.begin(), column.end(), S.col(j));
    }
    for (int j = 0; j < n; ++j) // symmetric but for the tolerance of the solves
      for (int i = 0; i < j; ++i)
        S(i, j) = S(j, i) = 0.5 * (S(i, j) + S(j, i));
    return S;
  }

  bool hasCheapSchur() const override { return false; }

  std::string description() const override
  {
    return fmt::format("{}, tolerance {:.0e}", description_, options_.tolerance);
  }

private:
  /// Set up when it is first needed: where whole bodies are solved together nobody asks.
  const KrylovSystem& interior() const
  {
    if (!interior_)
      interior_ = std::make_unique<KrylovSystem>(withKeptDofsAs(DofRole::Kept, freed_.problem()), comm_, ledger_,
                                                 options_, makeCg_, makeJoined_ != nullptr);
    return *interior_;
  }

  /// This rank's number of a kept dof among those of its own nodes, -1: another's.
  int ownDof(int kept) const
  {
    const int dof = freed_.problem().held(kept_[std::size_t(kept)]);
    return dof < matrix_.numRows() * matrix_.dim ? dof : -1;
  }

  FreedSystem freed_; ///< of nothing where there are no kept dofs
  KrylovOptions options_;
  MakeConjugateGradients makeCg_;
  MakeJoinedGradients makeJoined_;
  std::string description_;
  mutable std::unique_ptr<KrylovSystem> interior_;
};

} // namespace

std::unique_ptr<CondensedBody> makeKrylovBody(SolverProblem problem, const Comm& comm, Ledger& ledger,
                                              KrylovOptions options, MakeConjugateGradients makeCg,
                                              MakeJoinedGradients makeJoined, std::string description)
{
  return std::make_unique<KrylovBody>(std::move(problem), comm, ledger, options, std::move(makeCg),
                                      std::move(makeJoined), std::move(description));
}

} // namespace ndframe

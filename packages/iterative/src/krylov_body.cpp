#include "krylov_body.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "joined_krylov.hpp"
#include "krylov_system.hpp"
#include "ndframe/algebra/split_body.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "own_dofs.hpp"
#include "rank_problem.hpp"

namespace ndframe
{

namespace
{

RankProblem withKeptDofsAs(DofRole role, RankProblem problem)
{
  for (const RankProblem::Global kept : problem.kept)
    if (const int dof = problem.held(kept); dof >= 0)
      problem.roles[std::size_t(dof)] = role;
  return problem;
}

/// Nothing is factored: every back-solve is a run of conjugate gradients, and the Schur complement takes one per kept
/// dof.
class KrylovBody final : public SplitBody, public WholeSolver
{
public:
  KrylovBody(SolverProblem problem, const Comm& comm, Ledger& ledger, KrylovOptions options,
             MakeConjugateGradients makeCg, MakeJoinedGradients makeJoined, std::string description)
      : SplitBody(problem, comm, ledger),
        freed_(withKeptDofsAs(DofRole::Interior, heldPart(problem, makeJoined != nullptr))), options_(options),
        makeCg_(std::move(makeCg)), makeJoined_(std::move(makeJoined)), description_(std::move(description))
  {
    problem = {}; // as large as all nodes
    if (kept_.empty()) {
      interior_ = makeSystem(freed_);
      freed_ = {};
    }
  }

  DenseMatrix expand(const DenseMatrix& load, const DenseMatrix& kept) const override
  {
    checkShapes(load, kept);
    DenseMatrix u(numDofs(), load.cols());
    for (int j = 0; j < u.cols(); ++j) {
      Vector start(std::size_t(numDofs()), 0.0);
      for (int c = 0; c < numKept(); ++c)
        start[std::size_t(kept_[std::size_t(c)])] = kept(c, j);
      const Vector solution = interior().solve(load.column(j), start);
      std::copy(solution.begin(), solution.end(), u.col(j));
    }
    return u;
  }

  Vector solveNeumann(const Vector& force) const override
  {
    if (kept_.empty())
      return {};
    Vector load(std::size_t(numDofs()), 0.0), kept;
    for (std::size_t c = 0; c < kept_.size(); ++c)
      load[std::size_t(kept_[c])] = force[c];
    const Vector u = solveFree(load, Vector(load.size(), 0.0), Exactness::Full);
    for (const int dof : kept_)
      kept.push_back(u[std::size_t(dof)]);
    return kept;
  }

  bool solvesNeumann() const override { return true; }

  Vector solveFree(const Vector& load, Vector start, Exactness exactness) const override
  {
    Vector carried = ownPart(matrix_, load);
    for (std::size_t dof = 0; dof < carried.size(); ++dof)
      if (freed_.roles[dof] == DofRole::Fixed)
        carried[dof] = 0.0;
    const double size = normOf(carried, comm_);
    try {
      return freeSystem().solve(load, start, size, exactness);
    } catch (const SingularBody&) {
      if (largestEigenvalue_ == 0.0)
        throw;
    }
    free_.reset(); // the eigenvalue of others was too small
    largestEigenvalue_ = 0.0;
    return freeSystem().solve(load, start, size, exactness);
  }

  void forget() const override { free_.reset(); }

  void forgetSolutions() const override
  {
    for (const auto* system : {interior_.get(), free_.get()})
      if (system != nullptr)
        system->forgetSolutions();
  }

  void setLargestEigenvalue(double value) const override { largestEigenvalue_ = value; }

  bool solvesWhole() const override { return makeJoined_ != nullptr; }
  const RankProblem& freedProblem() const override { return freed_; }

  std::unique_ptr<JoinedSystem> join(const std::vector<const WholeSolver*>& bodies,
                                     const JoinedRows& open) const override
  {
    startMpi();
    std::vector<const RankProblem*> problems;
    for (const WholeSolver* body : bodies)
      problems.push_back(&body->freedProblem());
    double largest = 0.0;
    auto joined = makeJoinedKrylov(problems, open, comm_, ledger_, options_, makeJoined_, largest);
    for (const WholeSolver* body : bodies)
      body->setLargestEigenvalue(largest);
    return joined;
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
  std::unique_ptr<KrylovSystem> makeSystem(const RankProblem& problem) const
  {
    return std::make_unique<KrylovSystem>(problem, comm_, ledger_, options_, makeCg_, makeJoined_ != nullptr);
  }

  const KrylovSystem& freeSystem() const
  {
    if (!free_) {
      RankProblem held = freed_;
      for (const int k : motions_.held)
        if (const int dof = held.held(kept_[std::size_t(k)]); dof >= 0)
          held.roles[std::size_t(dof)] = DofRole::Fixed;
      held.largestEigenvalue = largestEigenvalue_;
      free_ = makeSystem(held);
    }
    return *free_;
  }

  /// Set up when it is first needed: where whole bodies are solved together nobody asks.
  const KrylovSystem& interior() const
  {
    if (!interior_)
      interior_ = makeSystem(withKeptDofsAs(DofRole::Kept, freed_));
    return *interior_;
  }

  RankProblem freed_; ///< with the kept dofs as interior ones; empty where there are none
  KrylovOptions options_;
  MakeConjugateGradients makeCg_;
  MakeJoinedGradients makeJoined_;
  std::string description_;
  mutable std::unique_ptr<KrylovSystem> interior_;
  mutable std::unique_ptr<KrylovSystem> free_; ///< with the kept dofs as unknowns: set up when it is first needed
  mutable double largestEigenvalue_ = 0.0;     ///< of the system that this body was joined to
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

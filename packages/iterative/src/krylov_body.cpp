#include "krylov_body.hpp"

#include <algorithm>
#include <mutex>

#include <fmt/format.h>

#include "cycle_count.hpp"
#include "joined_krylov.hpp"
#include "ndframe/algebra/split_body.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "own_dofs.hpp"
#include "recycled_solutions.hpp"
#include "restarted_gradients.hpp"
#include "stored_problem.hpp"

namespace ndframe
{

namespace
{

/// Bodies may be solved by several threads; the libraries are for one at a time.
std::mutex& librariesInUse()
{
  static std::mutex mutex;
  return mutex;
}

/// K on the dofs of one role, solved by conjugate gradients from a start that earlier solutions give.
class KrylovSystem
{
public:
  KrylovSystem(const SolverProblem& problem, const Comm& comm, Ledger& ledger, KrylovOptions options,
               const MakeConjugateGradients& makeCg, bool hasTwoLevels)
      : matrix_(*problem.matrix), roles_(problem.roles), comm_(comm), ledger_(ledger), options_(options)
  {
    const std::lock_guard lock(librariesInUse());
    startMpi();
    cg_ = makeCg(problem, comm, meanDiagonal(matrix_, comm));
    if (hasTwoLevels)
      ledger_.count("multigrid set-ups");
    work_.enter(cg_->work(), comm_, ledger_);
  }

  /// Improves u, whose kept and fixed values are given, until the true residual is small beside the first, or beside
  /// the reference if that is larger, or round-off. Throws NotConverged and SingularBody.
  Vector solve(const Vector& load, Vector u, double reference = 0.0, Exactness exactness = Exactness::Full) const
  {
    const std::lock_guard lock(librariesInUse());
    Vector residual = interiorResidual(load, u);
    const double initial = std::max(norm(residual), reference);
    u = sum(std::move(u), recycled_.start(residual));
    const Vector start = u, missing = residual = interiorResidual(load, u);
    const int iterations = restartedGradients(
        toleranceFor(exactness, options_.tolerance) * initial, initial, options_.maxIterations, norm(residual), ledger_,
        [&](double reduction, int most, const auto& watch) {
          const ConjugateGradients::Result step = cg_->solve(ownPart(matrix_, residual), reduction, most, watch);
          const Vector x = gathered(matrix_, step.x.data(), comm_);
          for (std::size_t dof = 0; dof < u.size(); ++dof)
            if (roles_[dof] == DofRole::Interior) // multigrid leaves round-off in the decoupled rows
              u[dof] += x[dof];
          return step.iterations;
        },
        [&] {
          residual = interiorResidual(load, u);
          return norm(residual);
        },
        [&] { return productRoundOff(matrix_, u, comm_); });
    if (iterations > 0)
      recycled_.add(difference(u, start), difference(missing, residual));
    ledger_.count("back-solves");
    ledger_.count("Krylov solves");
    ledger_.count("Krylov iterations", iterations);
    work_.enter(cg_->work(), comm_, ledger_);
    return u;
  }

  void forgetSolutions() const { recycled_ = {}; }

private:
  static Vector sum(Vector a, const Vector& b)
  {
    for (std::size_t i = 0; i < a.size(); ++i)
      a[i] += b[i];
    return a;
  }
  /// load - K u on the interior dofs, zero elsewhere.
  Vector interiorResidual(const Vector& load, const Vector& u) const
  {
    Vector residual = multiply(matrix_, u, comm_);
    work_.addResidual();
    for (std::size_t dof = 0; dof < residual.size(); ++dof)
      residual[dof] = roles_[dof] == DofRole::Interior ? load[dof] - residual[dof] : 0.0;
    return residual;
  }

  const BlockMatrix& matrix_;
  std::vector<DofRole> roles_;
  Comm comm_;
  Ledger& ledger_;
  KrylovOptions options_;
  std::unique_ptr<ConjugateGradients> cg_;
  mutable RecycledSolutions recycled_;
  mutable CycleCount work_;
};

/// The problem whose kept dofs are unknowns, too.
SolverProblem freed(const SolverProblem& problem, bool hasTwoLevels)
{
  if (problem.kept.empty())
    return {};
  SolverProblem result = hasTwoLevels ? withOwnVertices(problem) : problem;
  for (const int dof : result.kept)
    result.roles[std::size_t(dof)] = DofRole::Interior;
  return result;
}

/// Nothing is factored: every back-solve is a run of conjugate gradients, and the Schur complement takes one per kept
/// dof.
class KrylovBody final : public SplitBody, public WholeSolver
{
public:
  KrylovBody(const SolverProblem& problem, const Comm& comm, Ledger& ledger, KrylovOptions options,
             MakeConjugateGradients makeCg, MakeJoinedGradients makeJoined, std::string description)
      : SplitBody(problem, comm, ledger), freed_(freed(problem, makeJoined != nullptr)), options_(options),
        makeCg_(std::move(makeCg)), makeJoined_(std::move(makeJoined)), description_(std::move(description))
  {
    if (kept_.empty())
      interior_ = makeSystem(problem);
  }

  DenseMatrix expand(const DenseMatrix& load, const DenseMatrix& kept) const override
  {
    checkShapes(load, kept);
    DenseMatrix u(numDofs(), load.cols());
    for (int j = 0; j < u.cols(); ++j) {
      Vector start(std::size_t(numDofs()), 0.0);
      for (int c = 0; c < numKept(); ++c)
        start[std::size_t(kept_[std::size_t(c)])] = kept(c, j);
      const Vector solution = interior().solve(load.column(j), std::move(start));
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
    Vector carried = load;
    for (std::size_t dof = 0; dof < carried.size(); ++dof)
      if (roles_[dof] == DofRole::Fixed)
        carried[dof] = 0.0;
    try {
      return freeSystem().solve(load, start, norm(carried), exactness);
    } catch (const SingularBody&) {
      if (largestEigenvalue_ == 0.0)
        throw;
    }
    free_.reset(); // the eigenvalue of others was too small
    largestEigenvalue_ = 0.0;
    return freeSystem().solve(load, std::move(start), norm(carried), exactness);
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
  const SolverProblem& freedProblem() const override { return freed_; }

  std::unique_ptr<JoinedSystem> join(const std::vector<const WholeSolver*>& bodies,
                                     const JoinedRows& open) const override
  {
    startMpi();
    std::vector<const SolverProblem*> problems;
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
  std::unique_ptr<KrylovSystem> makeSystem(const SolverProblem& problem) const
  {
    return std::make_unique<KrylovSystem>(problem, comm_, ledger_, options_, makeCg_, makeJoined_ != nullptr);
  }

  const KrylovSystem& freeSystem() const
  {
    if (!free_) {
      SolverProblem held = freed_;
      for (const int k : motions_.held)
        held.roles[std::size_t(kept_[std::size_t(k)])] = DofRole::Fixed;
      held.largestEigenvalue = largestEigenvalue_;
      free_ = makeSystem(held);
    }
    return *free_;
  }

  /// Set up when it is first needed: where whole bodies are solved together nobody asks.
  const KrylovSystem& interior() const
  {
    if (!interior_) {
      SolverProblem split = freed_;
      split.roles = roles_;
      interior_ = makeSystem(split);
    }
    return *interior_;
  }

  SolverProblem freed_; ///< with the kept dofs as interior ones; empty where there are none
  KrylovOptions options_;
  MakeConjugateGradients makeCg_;
  MakeJoinedGradients makeJoined_;
  std::string description_;
  mutable std::unique_ptr<KrylovSystem> interior_;
  mutable std::unique_ptr<KrylovSystem> free_; ///< with the kept dofs as unknowns: set up when it is first needed
  mutable double largestEigenvalue_ = 0.0;     ///< of the system that this body was joined to
};

} // namespace

std::unique_ptr<CondensedBody> makeKrylovBody(const SolverProblem& problem, const Comm& comm, Ledger& ledger,
                                              KrylovOptions options, MakeConjugateGradients makeCg,
                                              MakeJoinedGradients makeJoined, std::string description)
{
  return std::make_unique<KrylovBody>(problem, comm, ledger, options, std::move(makeCg), std::move(makeJoined),
                                      std::move(description));
}

} // namespace ndframe

#include "krylov_body.hpp"

#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>

#include <fmt/format.h>

#include "ndframe/base/diagnostics.hpp"
#include "recycled_solutions.hpp"
#include "split_body.hpp"

namespace ndframe
{

namespace
{

double meanDiagonal(const BlockMatrix& K, const Comm& comm)
{
  const Vector d = diagonal(K, comm);
  return std::accumulate(d.begin(), d.end(), 0.0) / double(d.size());
}

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
               const MakeConjugateGradients& makeCg)
      : matrix_(*problem.matrix), roles_(problem.roles), comm_(comm), ledger_(ledger), options_(options)
  {
    const std::lock_guard lock(librariesInUse());
    startMpi();
    cg_ = makeCg(problem, comm, meanDiagonal(matrix_, comm));
    if (cg_->work().products > 0)
      ledger_.count("multigrid set-ups");
    countWork();
  }

  /// Improves u, whose kept and fixed values are given, until the true residual is small beside the first or round-off:
  /// CG follows a residual of its own that drifts, so it is started again on what is left. Throws NotConverged and
  /// SingularBody.
  Vector solve(const Vector& load, Vector u) const
  {
    const std::lock_guard lock(librariesInUse());
    Vector residual = interiorResidual(load, u);
    const double initial = norm(residual);
    u = sum(std::move(u), recycled_.start(residual));
    const Vector start = u, missing = residual = interiorResidual(load, u);
    double current = norm(residual), before = current;
    int iterations = 0;
    while (!(current <= options_.tolerance * initial || (2.0 * current > before && current <= roundOff(u)))) {
      if (iterations >= options_.maxIterations || !std::isfinite(current))
        throw NotConverged(fmt::format("Krylov: relative residual {:.2e} > {:.2e} after {} iterations; raise \"Maximum "
                                       "Iterations\" or use another preconditioner or a direct solver",
                                       current / initial, options_.tolerance, iterations));
      const double reduction = 0.5 * options_.tolerance * initial / current;
      ConjugateGradients::Result step = cg_->solve(residual, reduction, options_.maxIterations - iterations);
      comm_.sum(step.x);
      for (std::size_t dof = 0; dof < u.size(); ++dof)
        if (roles_[dof] == DofRole::Interior) // multigrid leaves round-off in the decoupled rows
          u[dof] += step.x[dof];
      iterations += std::max(step.iterations, 1);
      residual = interiorResidual(load, u);
      before = std::exchange(current, norm(residual));
    }
    if (iterations > 0)
      recycled_.add(difference(u, start), difference(missing, residual));
    ledger_.count("back-solves");
    ledger_.count("Krylov solves");
    ledger_.count("Krylov iterations", iterations);
    countWork();
    return u;
  }

private:
  static Vector sum(Vector a, const Vector& b)
  {
    for (std::size_t i = 0; i < a.size(); ++i)
      a[i] += b[i];
    return a;
  }
  static Vector difference(Vector a, const Vector& b)
  {
    for (std::size_t i = 0; i < a.size(); ++i)
      a[i] -= b[i];
    return a;
  }

  /// load - K u on the interior dofs, zero elsewhere.
  Vector interiorResidual(const Vector& load, const Vector& u) const
  {
    Vector residual = multiply(matrix_, u, comm_);
    ++residuals_;
    for (std::size_t dof = 0; dof < residual.size(); ++dof)
      residual[dof] = roles_[dof] == DofRole::Interior ? load[dof] - residual[dof] : 0.0;
    return residual;
  }

  /// What computing K u may leave of the residual, whatever u is: unit round-off times |K| |u|, and something for the
  /// length of the rows.
  double roundOff(const Vector& u) const
  {
    const int dim = matrix_.dim;
    Vector sizes(u.size(), 0.0);
    const double* entry = matrix_.values.data();
    for (std::size_t r = 0; r < matrix_.rows.size(); ++r)
      for (std::int64_t b = matrix_.rowPtr[r]; b < matrix_.rowPtr[r + 1]; ++b)
        for (int i = 0; i < dim; ++i)
          for (int j = 0; j < dim; ++j)
            sizes[std::size_t(matrix_.rows[r]) * std::size_t(dim) + std::size_t(i)] +=
                std::abs(*entry++ * u[std::size_t(matrix_.cols[std::size_t(b)]) * std::size_t(dim) + std::size_t(j)]);
    comm_.sum(sizes);
    return 16.0 * std::numeric_limits<double>::epsilon() * norm(sizes);
  }

  /// What two levels took since the last call.
  void countWork() const
  {
    const CycleWork now = cg_->work();
    if (now.products == 0)
      return;
    ledger_.count("fine products", now.products - counted_.products + std::exchange(residuals_, 0));
    ledger_.count("multigrid cycles", now.cycles - counted_.cycles);
    counted_ = now;
  }

  const BlockMatrix& matrix_;
  std::vector<DofRole> roles_;
  Comm comm_;
  Ledger& ledger_;
  KrylovOptions options_;
  std::unique_ptr<ConjugateGradients> cg_;
  mutable RecycledSolutions recycled_;
  mutable CycleWork counted_;
  mutable int residuals_ = 0; ///< products that are not counted yet
};

/// The problem whose kept dofs are unknowns, but for the held ones.
SolverProblem freeProblem(SolverProblem problem, const FreeMotions& motions)
{
  for (const int dof : problem.kept)
    problem.roles[std::size_t(dof)] = DofRole::Interior;
  for (const int held : motions.held)
    problem.roles[std::size_t(problem.kept[std::size_t(held)])] = DofRole::Fixed;
  problem.kept.clear();
  return problem;
}

/// Nothing is factored: every back-solve is a run of conjugate gradients, and the Schur complement takes one per kept
/// dof.
class KrylovBody final : public SplitBody
{
public:
  KrylovBody(const SolverProblem& problem, const Comm& comm, Ledger& ledger, KrylovOptions options,
             MakeConjugateGradients makeCg, std::string description)
      : SplitBody(problem, comm, ledger), problem_(problem.kept.empty() ? SolverProblem() : problem), options_(options),
        makeCg_(std::move(makeCg)), description_(std::move(description)), interior_(makeSystem(problem))
  {}

  DenseMatrix expand(const DenseMatrix& load, const DenseMatrix& kept) const override
  {
    checkShapes(load, kept);
    DenseMatrix u(numDofs(), load.cols());
    for (int j = 0; j < u.cols(); ++j) {
      Vector start(std::size_t(numDofs()), 0.0);
      for (int c = 0; c < numKept(); ++c)
        start[std::size_t(kept_[std::size_t(c)])] = kept(c, j);
      const Vector solution = interior_->solve(load.column(j), std::move(start));
      std::copy(solution.begin(), solution.end(), u.col(j));
    }
    return u;
  }

  Vector solveNeumann(const Vector& force) const override
  {
    if (kept_.empty())
      return {};
    if (!free_)
      free_ = makeSystem(freeProblem(problem_, motions_));
    Vector load(std::size_t(numDofs()), 0.0), kept;
    for (std::size_t c = 0; c < kept_.size(); ++c)
      load[std::size_t(kept_[c])] = force[c];
    const Vector u = free_->solve(load, Vector(load.size(), 0.0));
    for (const int dof : kept_)
      kept.push_back(u[std::size_t(dof)]);
    return kept;
  }

  bool solvesNeumann() const override { return true; }

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
    return std::make_unique<KrylovSystem>(problem, comm_, ledger_, options_, makeCg_);
  }

  SolverProblem problem_; ///< for the Neumann problem; empty without kept dofs
  KrylovOptions options_;
  MakeConjugateGradients makeCg_;
  std::string description_;
  std::unique_ptr<KrylovSystem> interior_;
  mutable std::unique_ptr<KrylovSystem> free_; ///< with the kept dofs as unknowns: set up when it is first needed
};

} // namespace

std::unique_ptr<CondensedBody> makeKrylovBody(const SolverProblem& problem, const Comm& comm, Ledger& ledger,
                                              KrylovOptions options, MakeConjugateGradients makeCg,
                                              std::string description)
{
  return std::make_unique<KrylovBody>(problem, comm, ledger, options, std::move(makeCg), std::move(description));
}

} // namespace ndframe

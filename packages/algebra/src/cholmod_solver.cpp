#include <algorithm>
#include <future>

#include <cblas.h>
#include <fmt/format.h>

#include "cholmod_factor.hpp"
#include "free_matrix.hpp"
#include "ndframe/algebra/direct_solvers.hpp"
#include "ndframe/algebra/solver_problem.hpp"
#include "ndframe/algebra/split_body.hpp"
#include "ndframe/algebra/threads.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ordering.hpp"

namespace ndframe
{

namespace
{

/// One factorisation of
///
///   [ K_ii  K_ic     ]   [ L_ii    ] [ L_ii^T  L_ci^T ]
///   [ K_ci  K_cc + D ] = [ L_ci  T ] [         T^T    ],   S = T T^T - D.
///
/// D is zero but where a floating body is held: at as many kept dofs as it has free motions, with a number of the size
/// of K_cc, which makes the matrix regular. Where that is not enough (unconnected parts, mechanisms) D is this number
/// everywhere, and there is no Neumann solve. D leaves K_ii and all that is computed from it untouched. Kept values are
/// prescribed by their image T^T u_c between the two half solves.
class CholmodBody final : public SplitBody
{
public:
  CholmodBody(const SolverProblem& problem, const Comm& comm, Ledger& ledger, FreeDofs free, Vector shift,
              std::unique_ptr<CholmodFactor> factor)
      : SplitBody(problem, comm, ledger), free_(std::move(free)), shift_(std::move(shift)), factor_(std::move(factor))
  {
    const auto shifts = std::count_if(shift_.begin(), shift_.end(), [](double s) { return s != 0.0; });
    solvesNeumann_ = std::size_t(shifts) == motions_.held.size();
    if (solvesNeumann_ && shifts > 0)
      respondHeld();
  }

  DenseMatrix expand(const DenseMatrix& load, const DenseMatrix& kept) const override
  {
    checkShapes(load, kept);
    DenseMatrix x = gather(load);
    factor_->forward(x);
    for (int j = 0; j < x.cols(); ++j) {
      const Vector image = factor_->trailingTransposedTimes(kept.col(j));
      std::copy(image.begin(), image.end(), x.col(j) + numInterior());
    }
    factor_->backward(x);
    ledger_.count("back-solves", x.cols());
    return scatter(x, kept);
  }

  /// The forward half ends with y_c = T^-1 g.
  DenseMatrix reduce(const DenseMatrix& load) const override
  {
    NDFRAME_ASSERT(load.rows() == numDofs(), "a load needs one row per dof");
    DenseMatrix x = gather(load);
    factor_->forward(x);
    ledger_.count("back-solves", x.cols());
    DenseMatrix g(numKept(), load.cols());
    for (int j = 0; j < g.cols(); ++j) {
      const Vector column = factor_->trailingTimes(x.col(j) + numInterior());
      std::copy(column.begin(), column.end(), g.col(j));
    }
    return g;
  }

  Vector applySchur(const Vector& kept) const override
  {
    ledger_.count("kept solves");
    Vector force = factor_->trailingTimes(factor_->trailingTransposedTimes(kept.data()).data());
    for (std::size_t c = 0; c < force.size(); ++c)
      force[c] -= shift_[c] * kept[c];
    return force;
  }

  /// (S + D) u = r, less what forces at the held dofs do that bring them back to zero.
  Vector solveNeumann(const Vector& force) const override
  {
    NDFRAME_ASSERT(solvesNeumann_, "this body has no Neumann solve");
    ledger_.count("kept solves");
    Vector u = factor_->trailingSolve(force);
    if (motions_.held.empty())
      return u;
    const Vector change = multiply(response_, valuesAtHeld(u));
    for (std::size_t c = 0; c < u.size(); ++c)
      u[c] -= change[c];
    for (const int held : motions_.held)
      u[std::size_t(held)] = 0.0;
    return u;
  }

  bool solvesNeumann() const override { return solvesNeumann_; }

  DenseMatrix schurComplement() const override
  {
    const DenseMatrix T = factor_->trailingBlock();
    const int n = T.rows();
    DenseMatrix S(n, n);
    if (n == 0)
      return S;
    cblas_dsyrk(CblasColMajor, CblasLower, CblasNoTrans, n, n, 1.0, T.data(), n, 0.0, S.data(), n);
    for (int j = 0; j < n; ++j) {
      S(j, j) -= shift_[std::size_t(j)];
      for (int i = j + 1; i < n; ++i)
        S(j, i) = S(i, j);
    }
    return S;
  }

  bool hasCheapSchur() const override { return true; }

  std::string description() const override
  {
    return fmt::format("Cholmod, METIS nested dissection, {:.2g} nonzeros", double(factor_->numNonzeros()));
  }

private:
  int numInterior() const { return factor_->size() - numKept(); }

  DenseMatrix gather(const DenseMatrix& load) const
  {
    DenseMatrix x(factor_->size(), load.cols());
    for (int j = 0; j < x.cols(); ++j)
      for (int k = 0; k < x.rows(); ++k)
        x(k, j) = load(free_.dofs[std::size_t(factor_->order(k))], j);
    return x;
  }

  DenseMatrix scatter(const DenseMatrix& x, const DenseMatrix& kept) const
  {
    DenseMatrix u(numDofs(), x.cols());
    for (int j = 0; j < x.cols(); ++j) {
      for (int k = 0; k < x.rows(); ++k)
        u(free_.dofs[std::size_t(factor_->order(k))], j) = x(k, j);
      for (int c = 0; c < numKept(); ++c)
        u(kept_[std::size_t(c)], j) = kept(c, j);
    }
    return u;
  }

  Vector valuesAtHeld(const Vector& u) const
  {
    Vector values;
    for (const int held : motions_.held)
      values.push_back(u[std::size_t(held)]);
    return values;
  }

  /// Displacements that are one at one held dof and zero at the others: G (G at the held dofs)^-1, (S + D) G = unit
  /// forces there.
  void respondHeld()
  {
    const int n = numKept(), count = int(motions_.held.size());
    DenseMatrix G(n, count), atHeld(count, count);
    for (int m = 0; m < count; ++m) {
      Vector unit(std::size_t(n), 0.0);
      unit[std::size_t(motions_.held[std::size_t(m)])] = 1.0;
      const Vector column = factor_->trailingSolve(std::move(unit)), values = valuesAtHeld(column);
      std::copy(column.begin(), column.end(), G.col(m));
      std::copy(values.begin(), values.end(), atHeld.col(m));
    }
    response_ = multiply(G, pseudoInverse(atHeld, 0.0));
  }

  FreeDofs free_;
  Vector shift_; ///< D, per kept dof
  std::unique_ptr<CholmodFactor> factor_;
  bool solvesNeumann_;
  DenseMatrix response_; ///< to unit displacements of the held dofs
};

std::unique_ptr<CholmodFactor> factorFree(const SolverProblem& problem, const FreeDofs& free, UpperTriangle A,
                                          const Vector& shift, std::vector<int> order, const Ledger& ledger)
{
  shiftKept(A, problem, free, shift);
  const auto tell = [&](double done, double all) {
    ledger.tell(Depth::Step, Progress::part("Gflop", std::llround(1e-9 * done), std::llround(1e-9 * all), done / all));
  };
  try {
    return std::make_unique<CholmodFactor>(std::move(A), std::move(order), int(problem.kept.size()), tell);
  } catch (const BadPivot& bad) {
    const int dof = free.dofs[std::size_t(bad.column)];
    throw SingularBody(fmt::format("the stiffness matrix is not positive definite at dof {}", dof), dof);
  }
}

/// `size` at the held dofs.
Vector shiftOfHeld(const FreeMotions& motions, double size)
{
  Vector shift(std::size_t(motions.traces.rows()), 0.0);
  for (const int held : motions.held)
    shift[std::size_t(held)] = size;
  return shift;
}

/// Deferred where no other thread may be or can be started.
std::launch besideOrdering(const Comm& comm)
{
  return numThreads(comm) > 1 ? std::launch::async | std::launch::deferred : std::launch::deferred;
}

class Cholmod final : public LinearSolver
{
public:
  std::unique_ptr<CondensedBody> factor(SolverProblem problem, const Comm& comm, Ledger& ledger) const override
  {
    if (comm.size() > 1)
      throw InputError("Cholmod runs on one rank; use Mumps or Krylov (or Automatic)");
    checkProblem(problem, comm);
    FreeDofs free(problem.roles);
    const double size = meanKeptDiagonal(problem, comm);
    Vector shift = shiftOfHeld(freeMotions(problem, comm), size);
    auto matrix = std::async(besideOrdering(comm), [&] { return freeUpperTriangle(problem, free); });
    const std::vector<int> order = eliminationOrder(problem, free, comm, ledger);
    const auto timer = ledger.time("factor");
    std::unique_ptr<CholmodFactor> factor;
    try {
      factor = factorFree(problem, free, matrix.get(), shift, order, ledger);
    } catch (const SingularBody& singular) {
      if (problem.roles[std::size_t(singular.dof)] != DofRole::Kept)
        throw;
      std::fill(shift.begin(), shift.end(), size); // more than its rigid motions is free
      factor = factorFree(problem, free, freeUpperTriangle(problem, free), shift, order, ledger);
    }
    ledger.count("factorisations");
    ledger.count("factor nonzeros", factor->numNonzeros());
    return std::make_unique<CholmodBody>(problem, comm, ledger, std::move(free), shift, std::move(factor));
  }

  std::string name(int) const override { return "Cholmod"; }
  bool needsMpi(int) const override { return false; }
  bool allowsThreads(int) const override { return true; }
};

} // namespace

std::unique_ptr<LinearSolver> makeCholmod()
{
  return std::make_unique<Cholmod>();
}

void registerCholmod(Registry<LinearSolver>& registry)
{
  registry.add("Cholmod", "Supernodal Cholesky of SuiteSparse, one rank; the Schur complement comes with the factor.",
               {}, [](const Params&) { return makeCholmod(); });
}

} // namespace ndframe

#include <algorithm>
#include <future>

#include <cblas.h>
#include <fmt/format.h>

#include "cholmod_factor.hpp"
#include "free_matrix.hpp"
#include "ndframe/algebra/threads.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ordering.hpp"
#include "solver_problem.hpp"
#include "solvers.hpp"
#include "split_body.hpp"

namespace ndframe
{

namespace
{

/// One factorisation of
///
///   [ K_ii  K_ic         ]   [ L_ii    ] [ L_ii^T  L_ci^T ]
///   [ K_ci  K_cc + s I   ] = [ L_ci  T ] [         T^T    ],   S = T T^T - s I.
///
/// The shift s, of the size of K_cc, makes a floating body's matrix regular; it leaves K_ii and everything computed
/// from it untouched. Kept values are prescribed by their image T^T u_c between the two half solves.
class CholmodBody final : public SplitBody
{
public:
  CholmodBody(const SolverProblem& problem, const Comm& comm, Ledger& ledger, FreeDofs free, double shift,
              std::unique_ptr<CholmodFactor> factor)
      : SplitBody(problem, comm, ledger), free_(std::move(free)), shift_(shift), factor_(std::move(factor))
  {}

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
    const DenseMatrix T = factor_->trailingBlock();
    DenseMatrix g(numKept(), load.cols());
    for (int j = 0; j < g.cols(); ++j) {
      const Vector column = multiply(T, Vector(x.col(j) + numInterior(), x.col(j) + x.rows()));
      std::copy(column.begin(), column.end(), g.col(j));
    }
    return g;
  }

  DenseMatrix schurComplement() const override
  {
    const DenseMatrix T = factor_->trailingBlock();
    const int n = T.rows();
    DenseMatrix S(n, n);
    if (n == 0)
      return S;
    cblas_dsyrk(CblasColMajor, CblasLower, CblasNoTrans, n, n, 1.0, T.data(), n, 0.0, S.data(), n);
    for (int j = 0; j < n; ++j) {
      S(j, j) -= shift_;
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

  FreeDofs free_;
  double shift_;
  std::unique_ptr<CholmodFactor> factor_;
};

std::unique_ptr<CholmodFactor> factorFree(const SolverProblem& problem, const FreeDofs& free, UpperTriangle A,
                                          std::vector<int> order)
{
  try {
    return std::make_unique<CholmodFactor>(std::move(A), std::move(order), int(problem.kept.size()));
  } catch (const BadPivot& bad) {
    const int dof = free.dofs[std::size_t(bad.column)];
    throw SingularBody(fmt::format("the stiffness matrix is not positive definite at dof {}", dof), dof);
  }
}

/// Deferred where no other thread may be or can be started.
std::launch besideOrdering(const Comm& comm)
{
  return numThreads(comm) > 1 ? std::launch::async | std::launch::deferred : std::launch::deferred;
}

class Cholmod final : public LinearSolver
{
public:
  std::unique_ptr<CondensedBody> factor(const SolverProblem& problem, const Comm& comm, Ledger& ledger) const override
  {
    if (comm.size() > 1)
      throw InputError("Cholmod runs on one rank; use Mumps or Krylov (or Automatic)");
    checkProblem(problem, comm);
    FreeDofs free(problem.roles);
    const double shift = meanKeptDiagonal(problem, comm);
    auto matrix = std::async(besideOrdering(comm), [&] { return freeUpperTriangle(problem, free, shift); });
    std::vector<int> order = eliminationOrder(problem, free, comm, ledger);
    const auto timer = ledger.time("factor");
    auto factor = factorFree(problem, free, matrix.get(), std::move(order));
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

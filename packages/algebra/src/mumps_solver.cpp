#include <algorithm>

#include <fmt/format.h>

#include "mumps_entries.hpp"
#include "mumps_instance.hpp"
#include "ndframe/algebra/direct_solvers.hpp"
#include "ndframe/algebra/solver_problem.hpp"
#include "ndframe/algebra/split_body.hpp"
#include "ndframe/algebra/symmetric_operator.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ordering.hpp"

namespace ndframe
{

namespace
{

/// A pivot of the scaled matrix below this is round-off; the same as Cholmod's.
constexpr double smallestPivot = 1e-12;

[[noreturn]] void rethrow(const MumpsFailure& failure)
{
  switch (failure.kind()) {
  case MumpsFailure::Kind::Singular:
    throw SingularBody(failure.what(), -1);
  case MumpsFailure::Kind::Memory:
  case MumpsFailure::Kind::Workspace:
    throw InputError(
        fmt::format("{}; use Multigrid as linear solver, more machines or a coarser mesh.", failure.what()));
  case MumpsFailure::Kind::Other:
    break;
  }
  throw InternalError(failure.what());
}

/// Partial factorisation of K on the free dofs, the kept dofs being MUMPS's Schur variables: S arrives on the host with
/// the factor, and solves run in two halves (reduction to S, expansion from the kept values).
class MumpsBody final : public SplitBody
{
public:
  MumpsBody(const SolverProblem& problem, const Comm& comm, Ledger& ledger, FreeDofs free)
      : SplitBody(problem, comm, ledger), free_(std::move(free)), mumps_(comm)
  {}

  /// `order` on rank 0: position -> free number. Throws SingularBody.
  void factor(const std::vector<int>& order)
  {
    LowerEntries entries = ownLowerEntries(matrix_, free_);
    std::vector<MUMPS_INT> positions = positionsFromOne(order), schurVariables = keptFromOne();
    setUp(entries, positions, schurVariables);
    try {
      mumps_.analyse();
      NDFRAME_ASSERT(mumps_.infog(7) == 1, "MUMPS did not take the ordering given to it");
      mumps_.factor();
    } catch (const MumpsFailure& failure) {
      rethrow(failure);
    }
    checkPivots();
    mumps_.data().irn_loc = mumps_.data().jcn_loc = mumps_.data().perm_in = mumps_.data().listvar_schur = nullptr;
    mumps_.data().a_loc = nullptr;
  }

  std::int64_t numNonzeros() const
  {
    const std::int64_t entries = mumps_.infog(29);
    return entries >= 0 ? entries : -entries * 1000000; // MUMPS counts in millions when an int does not hold it
  }

  DenseMatrix expand(const DenseMatrix& load, const DenseMatrix& kept) const override
  {
    checkShapes(load, kept);
    Vector x = gather(load);
    ledger_.count("back-solves", load.cols());
    if (numKept() == 0)
      solve(x, load.cols(), Half::Both, nullptr);
    else {
      Vector reduced(std::size_t(numKept()) * std::size_t(load.cols()));
      solve(x, load.cols(), Half::Reduction, reduced.data());
      std::copy_n(kept.data(), reduced.size(), reduced.data());
      solve(x, load.cols(), Half::Expansion, reduced.data());
    }
    comm_.broadcast(x);
    return scatter(x, kept);
  }

  DenseMatrix reduce(const DenseMatrix& load) const override
  {
    NDFRAME_ASSERT(load.rows() == numDofs(), "a load needs one row per dof");
    DenseMatrix g(numKept(), load.cols());
    if (numKept() == 0)
      return g;
    ledger_.count("back-solves", load.cols());
    Vector x = gather(load), reduced(std::size_t(g.rows()) * std::size_t(g.cols()));
    solve(x, load.cols(), Half::Reduction, reduced.data());
    comm_.broadcast(reduced);
    std::copy(reduced.begin(), reduced.end(), g.data());
    return g;
  }

  /// On the host, which has S.
  Vector applySchur(const Vector& kept) const override
  {
    ledger_.count("kept solves");
    Vector force(kept.size(), 0.0);
    if (comm_.rank() == 0)
      force = multiplyLowerRows(schur_, kept);
    comm_.broadcast(force);
    return force;
  }

  /// By a dense factor of S on the host, made when it is first needed.
  Vector solveNeumann(const Vector& force) const override
  {
    NDFRAME_ASSERT(solvesNeumann(), "this body has no Neumann solve");
    ledger_.count("kept solves");
    Vector u = force;
    if (inverse_)
      u = inverse_->solve(force);
    comm_.broadcast(u);
    return u;
  }

  bool solvesNeumann() const override
  {
    if (state_.empty()) {
      state_ = {1.0};
      if (comm_.rank() == 0)
        invert();
      comm_.broadcast(state_);
    }
    return state_.front() > 0.0;
  }

  DenseMatrix schurComplement() const override
  {
    Vector rows = schur_;
    comm_.broadcast(rows);
    return matrixOfLowerRows(rows, numKept());
  }

  bool hasCheapSchur() const override { return true; }

  std::string description() const override
  {
    return fmt::format("Mumps, METIS nested dissection, {:.2g} nonzeros, {} rank{}", double(numNonzeros()),
                       comm_.size(), comm_.size() == 1 ? "" : "s");
  }

private:
  void invert() const
  {
    std::vector<char> isFree(kept_.size(), 1);
    for (const int held : motions_.held)
      isFree[std::size_t(held)] = 0;
    try {
      inverse_ = makeDenseOperator(matrixOfLowerRows(schur_, numKept()))->inverseOn(isFree, 0.0);
    } catch (const NotPositiveDefinite&) {
      state_ = {0.0};
    }
  }

  /// ICNTL(26)
  enum class Half
  {
    Both = 0,
    Reduction = 1,
    Expansion = 2
  };

  std::vector<MUMPS_INT> keptFromOne() const
  {
    std::vector<MUMPS_INT> variables;
    for (const int dof : kept_)
      variables.push_back(free_.number[std::size_t(dof)] + 1);
    return variables;
  }

  void setUp(LowerEntries& entries, std::vector<MUMPS_INT>& positions, std::vector<MUMPS_INT>& schurVariables)
  {
    DMUMPS_STRUC_C& data = mumps_.data();
    data.n = free_.size();
    data.nnz_loc = MUMPS_INT8(entries.values.size());
    data.irn_loc = entries.rows.data();
    data.jcn_loc = entries.cols.data();
    data.a_loc = entries.values.data();
    data.perm_in = positions.data();
    mumps_.icntl(18) = 3; // every rank gives its entries
    mumps_.icntl(28) = 1; // analysis on the host
    mumps_.icntl(7) = 1;  // our ordering; MUMPS would drop its own METIS for AMD once a Schur complement is asked for
    mumps_.icntl(13) = 1; // no ScaLAPACK: it would hide the pivots of the last front
    mumps_.icntl(8) = 7;  // scale the diagonal to about one, which gives the smallest pivot a meaning
    if (numKept() == 0)
      return;
    mumps_.icntl(19) = 1; // Schur complement on the host
    data.size_schur = numKept();
    data.listvar_schur = schurVariables.data();
    if (comm_.rank() == 0)
      schur_.resize(std::size_t(numKept()) * std::size_t(numKept()));
    data.schur = schur_.data();
  }

  /// MUMPS keeps no record of where a pivot went wrong (with pivots from the diagonal only, as befits the problem).
  void checkPivots() const
  {
    const int numNegative = mumps_.infog(12);
    const double smallest = mumps_.rinfog(19);
    if (numNegative > 0 || !(smallest > smallestPivot))
      throw SingularBody(
          fmt::format("the stiffness matrix is not positive definite: {} negative pivots, the smallest of "
                      "all {:.1e} relative to the diagonal",
                      numNegative, smallest),
          -1);
  }

  Vector gather(const DenseMatrix& load) const
  {
    Vector x;
    if (comm_.rank() != 0)
      return x;
    x.reserve(free_.dofs.size() * std::size_t(load.cols()));
    for (int j = 0; j < load.cols(); ++j)
      for (const int dof : free_.dofs)
        x.push_back(load(dof, j));
    return x;
  }

  DenseMatrix scatter(const Vector& x, const DenseMatrix& kept) const
  {
    DenseMatrix u(numDofs(), kept.cols());
    auto value = x.begin();
    for (int j = 0; j < u.cols(); ++j) {
      for (const int dof : free_.dofs)
        u(dof, j) = *value++;
      for (int c = 0; c < numKept(); ++c)
        u(kept_[std::size_t(c)], j) = kept(c, j);
    }
    return u;
  }

  /// x (and the reduced values) on the host.
  void solve(Vector& x, int numColumns, Half half, double* reduced) const
  {
    if (numColumns == 0)
      return;
    DMUMPS_STRUC_C& data = mumps_.data();
    data.rhs = x.data();
    data.lrhs = data.n;
    data.nrhs = numColumns;
    data.redrhs = reduced;
    data.lredrhs = numKept();
    mumps_.icntl(26) = int(half);
    mumps_.solve();
  }

  FreeDofs free_;
  Vector schur_;                                       ///< on the host
  mutable std::unique_ptr<RestrictedInverse> inverse_; ///< on the host
  mutable Vector state_;                               ///< empty before invert(); 1 if it has an inverse
  mutable MumpsInstance mumps_;
};

class Mumps final : public LinearSolver
{
public:
  std::unique_ptr<CondensedBody> factor(SolverProblem problem, const Comm& comm, Ledger& ledger) const override
  {
    checkProblem(problem, comm);
    if (std::count(problem.roles.begin(), problem.roles.end(), DofRole::Interior) == 0)
      throw InputError("Mumps needs a body with dofs besides those of the interface; use Cholmod or a finer mesh.");
    FreeDofs free(problem.roles);
    const std::vector<int> order = eliminationOrder(problem, free, comm, ledger);
    const auto timer = ledger.time("factor");
    auto body = std::make_unique<MumpsBody>(problem, comm, ledger, std::move(free));
    body->factor(order);
    ledger.count("factorisations");
    ledger.count("factor nonzeros", body->numNonzeros());
    return body;
  }

  std::string name(int) const override { return "Mumps"; }
  bool needsMpi(int) const override { return true; }
};

} // namespace

std::unique_ptr<LinearSolver> makeMumps()
{
  return std::make_unique<Mumps>();
}

void registerMumps(Registry<LinearSolver>& registry)
{
  registry.add("Mumps", "Distributed multifrontal factorisation, any number of ranks.", {},
               [](const Params&) { return makeMumps(); });
}

} // namespace ndframe

#include "ndframe/iterative/linear_solvers.hpp"

#include "ndframe/algebra/direct_solvers.hpp"
#include "ndframe/algebra/rank_problem.hpp"
#include "solvers.hpp"

namespace ndframe
{

namespace
{

/// Above so many dofs the factor of a solid costs more than a run of conjugate gradients with two levels and the start
/// of its libraries. docs/performance.md has the measurements.
constexpr int largeSolid = 40000;

/// The same of all bodies in contact: their statuses are found on the way.
constexpr int largeContact = 60000;

/// Where the volume hardly changes linear functions lock, and the level of the vertices is of no use.
constexpr double nearlyIncompressible = 0.48;

/// More of them, as flat cells need, cost more than the factor, which is then taken after all.
constexpr int mostIterations = 200;

/// The same where no factor can be had.
constexpr int mostIterationsOfShares = 1000;

/// The solver that is fastest for the number of ranks and the body.
class Automatic final : public LinearSolver
{
public:
  std::unique_ptr<CondensedBody> factor(SolverProblem problem, const Comm& comm, Ledger& ledger) const override
  {
    const auto solver = choose(problem.outline, comm.size());
    return solver->factor(std::move(problem), comm, ledger);
  }
  std::unique_ptr<CondensedBody> share(RankProblem problem, const Comm& comm, Ledger& ledger) const override
  {
    return makeMultigrid(mostIterationsOfShares)->share(std::move(problem), comm, ledger);
  }
  std::string name(const BodyOutline& body, int ranks) const override { return choose(body, ranks)->name(ranks); }
  std::string name(int ranks) const override { return choose(ranks)->name(ranks); }
  bool needsMpi(int ranks) const override { return choose(ranks)->needsMpi(ranks); }
  bool allowsThreads(int ranks) const override { return choose(ranks)->allowsThreads(ranks); }

private:
  /// Contact takes S, which comes with a factor and else costs a run of conjugate gradients for each of its columns.
  static std::unique_ptr<LinearSolver> choose(const BodyOutline& body, int ranks)
  {
    const bool isLarge = body.dim == 3 && body.dofs >= (body.bodies == 1 ? largeSolid : largeContact);
    return isLarge && !body.isCondensed && body.poissonRatio <= nearlyIncompressible
               ? makeWithSecondChoice(makeMultigrid(mostIterations), choose(ranks))
               : choose(ranks);
  }
  static std::unique_ptr<LinearSolver> choose(int ranks) { return ranks == 1 ? makeCholmod() : makeMumps(); }
};

void registerAutomatic(Registry<LinearSolver>& registry)
{
  registry.add("Automatic",
               "Cholmod on one rank, Mumps on several; Multigrid for solids of 40 000 dofs and more, of 60 000 where "
               "bodies touch and Monolithic couples them, unless they are nearly incompressible (Poisson ratio above "
               "0.48); a factor after all where Multigrid takes more than 200 iterations.",
               {}, [](const Params&) { return std::make_unique<Automatic>(); });
}

} // namespace

void registerLinearSolvers(Registry<LinearSolver>& registry)
{
  registerAutomatic(registry);
  registerCholmod(registry);
  registerMumps(registry);
  registerMultigrid(registry);
  registerKrylov(registry);
}

} // namespace ndframe

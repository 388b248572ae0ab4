#include "solvers.hpp"

namespace ndframe
{

namespace
{

/// The direct solver that is fastest for the number of ranks.
class Automatic final : public LinearSolver
{
public:
  std::unique_ptr<CondensedBody> factor(const SolverProblem& problem, const Comm& comm, Ledger& ledger) const override
  {
    return choose(comm.size())->factor(problem, comm, ledger);
  }
  std::string name(int ranks) const override { return choose(ranks)->name(ranks); }
  bool needsMpi(int ranks) const override { return choose(ranks)->needsMpi(ranks); }
  bool allowsThreads(int ranks) const override { return choose(ranks)->allowsThreads(ranks); }

private:
  static std::unique_ptr<LinearSolver> choose(int ranks) { return ranks == 1 ? makeCholmod() : makeMumps(); }
};

void registerAutomatic(Registry<LinearSolver>& registry)
{
  registry.add("Automatic", "Cholmod on one rank, Mumps on several.", {},
               [](const Params&) { return std::make_unique<Automatic>(); });
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

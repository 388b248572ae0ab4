#include <fmt/format.h>

#include "krylov_body.hpp"
#include "krylov_module.hpp"
#include "krylov_share.hpp"
#include "library_list.hpp"
#include "ndframe/algebra/solver_problem.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/iterative/linear_level.hpp"
#include "preconditioner_registry.hpp"
#include "solvers.hpp"

namespace ndframe
{

namespace
{

/// Conjugate gradients with a preconditioner of one of the libraries for all nodes ("Krylov"), or for the vertices,
/// below Chebyshev's polynomials on all nodes ("Multigrid"). Where all nodes are vertices it is the first either way.
class Krylov final : public LinearSolver
{
public:
  Krylov(std::string name, KrylovOptions options, std::unique_ptr<Preconditioner> preconditioner,
         const Teuchos::ParameterList& belos)
      : name_(std::move(name)), options_(options), preconditioner_(std::move(preconditioner)), belos_(belos),
        hasTwoLevels_(name_ == "Multigrid")
  {}

  std::unique_ptr<CondensedBody> factor(SolverProblem problem, const Comm& comm, Ledger& ledger) const override
  {
    checkProblem(problem, comm);
    const auto timer = ledger.time("factor");
    const bool twoLevels = hasTwoLevels_ && !problem.edgeNodes.ends.empty();
    return makeKrylovBody(std::move(problem), comm, ledger, options_, gradients(twoLevels),
                          twoLevels ? joining() : MakeJoinedGradients(), description(twoLevels));
  }

  std::unique_ptr<CondensedBody> share(RankProblem problem, const Comm& comm, Ledger& ledger) const override
  {
    if (!hasTwoLevels_)
      return nullptr;
    const auto timer = ledger.time("factor");
    startMpi();
    return makeKrylovShare(std::move(problem), comm, ledger, options_, gradients(true), joining(), description(true));
  }

  std::string name(int) const override { return name_; }
  bool needsMpi(int) const override { return true; } // Ifpack2 and MueLu call it even on one process

private:
  MakeConjugateGradients gradients(bool twoLevels) const
  {
    return [preconditioner = preconditioner_, belos = belos_, twoLevels](const RankProblem& given, const Comm& ranks,
                                                                         double decoupledDiagonal) {
      return makeCg(given, ranks, decoupledDiagonal, *preconditioner, belos, twoLevels);
    };
  }
  MakeJoinedGradients joining() const
  {
    return [preconditioner = preconditioner_, belos = belos_](const JoinedBodies& bodies,
                                                              const JoinedUnknowns& unknowns, const Comm& ranks) {
      return krylovLibrary().joined(bodies, unknowns, ranks, preconditioner, belos);
    };
  }
  std::string description(bool twoLevels) const
  {
    return fmt::format("{}, Belos CG, {}{}", name_, twoLevels ? "Chebyshev and on the vertices " : "",
                       preconditioner_->name());
  }

  static std::unique_ptr<ConjugateGradients> makeCg(const RankProblem& problem, const Comm& comm,
                                                    double decoupledDiagonal, const Preconditioner& preconditioner,
                                                    const Teuchos::ParameterList& belos, bool twoLevels)
  {
    const KrylovLibrary& library = krylovLibrary();
    try {
      if (!twoLevels)
        return library.conjugateGradients(problem, comm, decoupledDiagonal, preconditioner, belos);
      const LinearLevel level(problem, comm);
      return library.twoLevels(problem, level, comm, decoupledDiagonal, preconditioner, belos);
    } catch (const Teuchos::Exceptions::InvalidParameter& refusal) {
      throw InputError(fmt::format("{} does not take its parameters: {}", preconditioner.name(), refusal.what()));
    }
  }

  std::string name_;
  KrylovOptions options_;
  std::shared_ptr<const Preconditioner> preconditioner_;
  Teuchos::ParameterList belos_;
  bool hasTwoLevels_;
};

std::vector<std::string> belosMistakes(const Teuchos::ParameterList& list)
{
  return mistakesIn(list, krylovLibrary().validBelos(), "Belos",
                    {"Convergence Tolerance", "Maximum Iterations", "Output Stream"});
}

ListSpec belosList()
{
  ListSpec belos;
  belos.name = "Belos";
  belos.doc = "Parameters of Belos's pseudo-block conjugate gradients, e.g. \"Verbosity\".";
  belos.passThrough = belosMistakes;
  return belos;
}

ListSpec preconditionerList()
{
  ListSpec preconditioner;
  preconditioner.name = "Preconditioner";
  preconditioner.doc = "What makes the conjugate gradients converge.";
  preconditioner.choices = preconditioners().choices();
  return preconditioner;
}

constexpr KrylovOptions defaults = {1e-10, 1000};

std::vector<ParamSpec> iterationParameters()
{
  return {{"Tolerance", defaults.tolerance, inOpenRange(0.0, 1.0),
           "True residual of a solve relative to its right-hand side."},
          {"Maximum Iterations", defaults.maxIterations, atLeast(1.0), "Iterations of one solve."}};
}

std::unique_ptr<LinearSolver> makeKrylov(const std::string& name, const Params& params,
                                         std::unique_ptr<Preconditioner> preconditioner)
{
  const KrylovOptions options = {params.get<double>("Tolerance"), params.get<int>("Maximum Iterations")};
  return std::make_unique<Krylov>(name, options, std::move(preconditioner),
                                  conformed(params.sub("Belos").teuchos(), krylovLibrary().validBelos()));
}

} // namespace

std::unique_ptr<LinearSolver> makeMultigrid(int maxIterations)
{
  return std::make_unique<Krylov>("Multigrid", KrylovOptions{defaults.tolerance, maxIterations}, makeVertexMueLu({}),
                                  Teuchos::ParameterList());
}

void registerKrylov(Registry<LinearSolver>& registry)
{
  registry.add("Krylov", "Preconditioned conjugate gradients, any number of ranks; memory grows only with the mesh.",
               iterationParameters(),
               [](const Params& params) {
                 return makeKrylov("Krylov", params, preconditioners().build(params.sub("Preconditioner")));
               },
               {belosList(), preconditionerList()});
}

void registerMultigrid(Registry<LinearSolver>& registry)
{
  registry.add(
      "Multigrid",
      "Conjugate gradients with a two-level preconditioner: Chebyshev polynomials on all nodes, algebraic multigrid of "
      "MueLu on the vertices (with order 1 these are all nodes). Any number of ranks; for large solids.",
      iterationParameters(),
      [](const Params& params) {
        return makeKrylov("Multigrid", params, makeVertexMueLu(params.sub("MueLu").teuchos()));
      },
      {belosList(), mueLuList()});
}

} // namespace ndframe

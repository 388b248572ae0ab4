#include "ndframe/iterative/krylov_library.hpp"

#include <Kokkos_Core.hpp>

#include "belos_cg.hpp"
#include "block_operator.hpp"
#include "joined_gradients.hpp"
#include "linear_transfer.hpp"
#include "preconditioners.hpp"
#include "two_level_cycle.hpp"

namespace ndframe
{

namespace
{

/// Tpetra would start Kokkos too, but warn about what it does not find.
void startKokkos()
{
  if (Kokkos::is_initialized())
    return;
  Kokkos::InitArguments arguments;
  arguments.disable_warnings = true;
  Kokkos::initialize(arguments);
}

class TrilinosKrylov final : public KrylovLibrary
{
public:
  const Teuchos::ParameterList& validBelos() const override { return validBelosList(); }
  const Teuchos::ParameterList& validIfpack2() const override { return validIfpack2List(); }
  const Teuchos::ParameterList& validMueLu() const override { return validMueLuList(); }

  std::unique_ptr<Preconditioner> ifpack2(const std::string& method, const Teuchos::ParameterList& list) const override
  {
    return makeIfpack2(method, list);
  }
  std::unique_ptr<Preconditioner> mueLu(const Teuchos::ParameterList& list) const override { return makeMueLu(list); }

  std::unique_ptr<ConjugateGradients> conjugateGradients(const RankProblem& problem, const Comm& comm,
                                                         double decoupledDiagonal, const Preconditioner& preconditioner,
                                                         const Teuchos::ParameterList& belos) const override
  {
    startKokkos();
    const TpetraSystem system(problem, comm, decoupledDiagonal);
    return makeBelosCg({system.matrix, preconditioner.build(system)->apply}, belos);
  }

  std::unique_ptr<ConjugateGradients> twoLevels(const RankProblem& problem, const LinearLevel& level, const Comm& comm,
                                                double decoupledDiagonal, const Preconditioner& coarse,
                                                const Teuchos::ParameterList& belos) const override
  {
    startKokkos();
    const auto matrix = Teuchos::rcp(new BlockOperator(problem, comm));
    const TpetraSystem system(level.problem, comm, decoupledDiagonal);
    const auto cycle = Teuchos::rcp(new TwoLevelCycle(
        matrix, std::make_unique<LinearTransfer>(problem, level, system.dofMap), problem.largestEigenvalue));
    cycle->setCoarse(system, coarse);
    const auto work = [matrix, cycle] { return workOf(*matrix, *cycle); };
    return makeBelosCg({matrix, cycle, work}, belos);
  }

  std::unique_ptr<JoinedGradients> joined(const JoinedBodies& bodies, const JoinedUnknowns& unknowns, const Comm& comm,
                                          std::shared_ptr<const Preconditioner> coarse,
                                          const Teuchos::ParameterList& belos) const override
  {
    startKokkos();
    return makeJoinedGradients(bodies, unknowns, comm, std::move(coarse), belos);
  }

  void finish() const override
  {
    if (Kokkos::is_initialized())
      Kokkos::finalize();
  }
};

} // namespace

} // namespace ndframe

/// What the program looks up in the module.
extern "C" const ndframe::KrylovLibrary* ndframeKrylovLibrary()
{
  static const ndframe::TrilinosKrylov library;
  return &library;
}

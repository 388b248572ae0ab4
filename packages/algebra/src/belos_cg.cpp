#include "belos_cg.hpp"

#include <BelosCGIteration.hpp>
#include <BelosSolverFactory.hpp>
#include <BelosTpetraAdapter.hpp>
#include <Teuchos_oblackholestream.hpp>
#include <fmt/format.h>

#include "library_list.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "tpetra_system.hpp"

namespace ndframe
{

namespace
{

using Problem = Belos::LinearProblem<double, TpetraVectors, TpetraOperator>;
using Manager = Belos::SolverManager<double, TpetraVectors, TpetraOperator>;
using Local = TpetraMap::local_ordinal_type;

Teuchos::RCP<Manager> makeManager(const Teuchos::RCP<Teuchos::ParameterList>& list)
{
  return Belos::SolverFactory<double, TpetraVectors, TpetraOperator>().create("Pseudoblock CG", list);
}

const Teuchos::ParameterList& validBelos()
{
  static const Teuchos::RCP<const Teuchos::ParameterList> valid =
      makeManager(Teuchos::parameterList())->getValidParameters();
  return *valid;
}

/// Belos speaks only if it is asked to; else its own words on a failure would precede ours.
Teuchos::ParameterList quietUnlessAsked(Teuchos::ParameterList list)
{
  if (!list.isParameter("Verbosity"))
    list.set<Teuchos::RCP<std::ostream>>("Output Stream", Teuchos::rcp(new Teuchos::oblackholestream));
  return list;
}

} // namespace

struct BelosCg::Parts
{
  TpetraSystem system;
  std::shared_ptr<PreconditionerHandle> preconditioner;
  Comm comm;
  Teuchos::ParameterList list;

  Teuchos::RCP<TpetraVectors> ownPart(const Vector& replicated) const
  {
    const auto own = Teuchos::rcp(new TpetraVectors(system.dofMap, 1));
    const auto values = own->getDataNonConst(0);
    for (Local i = 0; i < Local(values.size()); ++i)
      values[i] = replicated[std::size_t(system.dofMap->getGlobalElement(i))];
    return own;
  }

  Vector replicated(const TpetraVectors& own, std::size_t size) const
  {
    Vector all(size, 0.0);
    const auto values = own.getData(0);
    for (Local i = 0; i < Local(values.size()); ++i)
      all[std::size_t(system.dofMap->getGlobalElement(i))] = values[i];
    comm.sum(all);
    return all;
  }
};

BelosCg::BelosCg(const SolverProblem& problem, const Comm& comm, const Preconditioner& preconditioner,
                 const Teuchos::ParameterList& list)
    : parts_(new Parts{TpetraSystem(problem, comm), nullptr, comm, quietUnlessAsked(conformed(list, validBelos()))})
{
  try {
    parts_->preconditioner = preconditioner.build(parts_->system);
  } catch (const Teuchos::Exceptions::InvalidParameter& refusal) {
    throw InputError(fmt::format("{} does not take its parameters: {}", preconditioner.name(), refusal.what()));
  }
}

BelosCg::~BelosCg() = default;

BelosCg::Result BelosCg::solve(const Vector& b, double tolerance, int maxIterations) const
{
  const auto x = Teuchos::rcp(new TpetraVectors(parts_->system.dofMap, 1));
  const auto problem = Teuchos::rcp(new Problem(parts_->system.matrix, x, parts_->ownPart(b)));
  problem->setLeftPrec(parts_->preconditioner->apply);
  problem->setProblem();
  const auto list = Teuchos::parameterList(parts_->list);
  list->set("Convergence Tolerance", tolerance);
  list->set("Maximum Iterations", maxIterations);
  const auto manager = makeManager(list);
  manager->setProblem(problem);
  try {
    manager->solve();
  } catch (const Belos::CGIterateFailure&) {
    throw SingularBody("conjugate gradients met a motion without positive energy: the stiffness matrix or the "
                       "preconditioner is not positive definite",
                       -1);
  }
  return {parts_->replicated(*x, b.size()), manager->getNumIters()};
}

std::vector<std::string> belosMistakes(const Teuchos::ParameterList& list)
{
  return mistakesIn(list, validBelos(), "Belos", {"Convergence Tolerance", "Maximum Iterations", "Output Stream"});
}

} // namespace ndframe

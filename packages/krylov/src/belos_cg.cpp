#include "belos_cg.hpp"

#include <BelosCGIteration.hpp>
#include <BelosSolverFactory.hpp>
#include <BelosTpetraAdapter.hpp>
#include <Teuchos_oblackholestream.hpp>

namespace ndframe
{

namespace
{

using Problem = Belos::LinearProblem<double, TpetraVectors, TpetraOperator>;
using Manager = Belos::SolverManager<double, TpetraVectors, TpetraOperator>;

Teuchos::RCP<Manager> makeManager(const Teuchos::RCP<Teuchos::ParameterList>& list)
{
  return Belos::SolverFactory<double, TpetraVectors, TpetraOperator>().create("Pseudoblock CG", list);
}

/// Belos speaks only if it is asked to; else its own words on a failure would precede ours.
Teuchos::ParameterList quietUnlessAsked(Teuchos::ParameterList list)
{
  if (!list.isParameter("Verbosity"))
    list.set<Teuchos::RCP<std::ostream>>("Output Stream", Teuchos::rcp(new Teuchos::oblackholestream));
  return list;
}

/// A preconditioner that tells how large the residuals are that it gets: Belos has nobody else who sees them all. What
/// it makes of the last one is not used: Belos asks for it, and then sees that the residual is small enough.
class WatchedPreconditioner final : public TpetraOperator
{
public:
  WatchedPreconditioner(Teuchos::RCP<const TpetraOperator> inner, double enough, const ConjugateGradients::Watch& watch)
      : inner_(std::move(inner)), enough_(enough), watch_(watch)
  {}

  void apply(const TpetraVectors& X, TpetraVectors& Y, Teuchos::ETransp mode, double alpha, double beta) const override
  {
    const double size = X.getVector(0)->norm2();
    first_ = applied_ == 0 ? size : first_;
    if (applied_ % between == 0)
      watch_(applied_ + 1, first_ > 0.0 ? size / first_ : 0.0);
    ++applied_;
    if (size <= enough_ * first_)
      Tpetra::deep_copy(Y, X);
    else
      inner_->apply(X, Y, mode, alpha, beta);
  }

  Teuchos::RCP<const TpetraMap> getDomainMap() const override { return inner_->getDomainMap(); }
  Teuchos::RCP<const TpetraMap> getRangeMap() const override { return inner_->getRangeMap(); }

private:
  static constexpr int between = 10; ///< often enough for a user

  Teuchos::RCP<const TpetraOperator> inner_;
  double enough_; ///< of the first residual
  const ConjugateGradients::Watch& watch_;
  mutable int applied_ = 0;
  mutable double first_ = 0.0;
};

class BelosCg final : public ConjugateGradients
{
public:
  BelosCg(PreconditionedMatrix system, const Teuchos::ParameterList& list)
      : system_(std::move(system)), dofMap_(system_.matrix->getDomainMap()), list_(quietUnlessAsked(list)),
        isScaled_(list.isParameter("Residual Scaling") || list.isParameter("Implicit Residual Scaling"))
  {}

  CycleWork work() const override { return system_.work ? system_.work() : CycleWork(); }

  Result solve(const Vector& b, double tolerance, int maxIterations, const Watch& watch) const override
  {
    const auto x = Teuchos::rcp(new TpetraVectors(dofMap_, 1));
    const auto load = vectorOf(b);
    const auto problem = Teuchos::rcp(new Problem(system_.matrix, x, load));
    problem->setInitResVec(load);
    problem->setRightPrec( // a left one is applied twice at the start, and is the same to conjugate gradients
        Teuchos::rcp(new WatchedPreconditioner(system_.preconditioner, isScaled_ ? 0.0 : sure * tolerance, watch)));
    problem->setProblem();
    const auto list = Teuchos::parameterList(list_);
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
    return {valuesOf(*x), manager->getNumIters()};
  }

private:
  Teuchos::RCP<TpetraVectors> vectorOf(const Vector& own) const
  {
    const auto vector = Teuchos::rcp(new TpetraVectors(dofMap_, 1));
    std::copy(own.begin(), own.end(), vector->getDataNonConst(0).getRawPtr());
    return vector;
  }

  static Vector valuesOf(const TpetraVectors& vector)
  {
    const auto values = vector.getData(0);
    return {values.begin(), values.end()};
  }

  PreconditionedMatrix system_;
  Teuchos::RCP<const TpetraMap> dofMap_;
  Teuchos::ParameterList list_;
  bool isScaled_; ///< whether residuals are relative to something else than the first one

  static constexpr double sure = 1.0 - 1e-9; ///< that Belos finds the tolerance reached, too, whatever the last bit
};

} // namespace

std::unique_ptr<ConjugateGradients> makeBelosCg(PreconditionedMatrix system, const Teuchos::ParameterList& list)
{
  return std::make_unique<BelosCg>(std::move(system), list);
}

const Teuchos::ParameterList& validBelosList()
{
  static const Teuchos::RCP<const Teuchos::ParameterList> valid =
      makeManager(Teuchos::parameterList())->getValidParameters();
  return *valid;
}

} // namespace ndframe

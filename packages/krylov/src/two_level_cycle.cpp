#include "two_level_cycle.hpp"

#include <algorithm>

#include "largest_eigenvalue.hpp"

namespace ndframe
{

namespace
{

Teuchos::RCP<TpetraVectors> vectorOn(const Teuchos::RCP<const TpetraMap>& map)
{
  return Teuchos::rcp(new TpetraVectors(map, 1));
}

} // namespace

TwoLevelCycle::TwoLevelCycle(Teuchos::RCP<const FineOperator> matrix, std::unique_ptr<FineTransfer> transfer,
                             double largest)
    : matrix_(std::move(matrix)), inverseDiagonal_(matrix_->inverseDiagonal()),
      largest_(largest > 0.0 ? largest : ndframe::largestEigenvalue(*matrix_, inverseDiagonal_, lanczosSteps)),
      centre_(0.5 * largest_ * (margin + 1.0 / smoothedShare)),
      halfWidth_(0.5 * largest_ * (margin - 1.0 / smoothedShare)), transfer_(std::move(transfer)),
      residual_(inverseDiagonal_.size()), product_(inverseDiagonal_.size()), step_(vectorOn(getDomainMap())),
      nextStep_(vectorOn(getDomainMap()))
{}

void TwoLevelCycle::setCoarse(const TpetraSystem& system, const Preconditioner& coarse)
{
  dropCoarse();
  coarse_ = coarse.build(system);
  coarseLoad_ = vectorOn(system.dofMap);
  coarseSolution_ = vectorOn(system.dofMap);
}

void TwoLevelCycle::shareCoarse(const TwoLevelCycle& other)
{
  coarse_ = other.coarse_;
  coarseLoad_ = other.coarseLoad_;
  coarseSolution_ = other.coarseSolution_;
}

void TwoLevelCycle::apply(const TpetraVectors& b, TpetraVectors& x, Teuchos::ETransp, double, double) const
{
  for (std::size_t j = 0; j < b.getNumVectors(); ++j) {
    const auto given = b.getData(j);
    const auto result = x.getDataNonConst(j);
    cycle(given.getRawPtr(), result.getRawPtr());
    ++cycles_;
  }
}

Traffic TwoLevelCycle::traffic() const
{
  Traffic sum = transfer_->traffic();
  sum += coarseTraffic_;
  return sum;
}

void TwoLevelCycle::cycle(const double* b, double* x) const
{
  {
    const auto first = step_->getDataNonConst(0);
    for (std::size_t i = 0; i < residual_.size(); ++i) {
      residual_[i] = b[i];
      x[i] = first.getRawPtr()[i] = inverseDiagonal_[i] * b[i] / centre_;
    }
  }
  smooth(x, true);
  transfer_->toCoarse(residual_.data(), *coarseLoad_);
  coarse_->apply->apply(*coarseLoad_, *coarseSolution_);
  coarseTraffic_ += coarse_->traffic;
  transfer_->toFine(*coarseSolution_, step_->getDataNonConst(0).getRawPtr());
  {
    const auto correction = step_->getData(0);
    const auto first = nextStep_->getDataNonConst(0);
    const double* c = correction.getRawPtr();
    double* const d = first.getRawPtr();
    matrix_->multiply(*step_, product_.data());
    for (std::size_t i = 0; i < residual_.size(); ++i) {
      residual_[i] -= product_[i];
      d[i] = inverseDiagonal_[i] * residual_[i] / centre_;
      x[i] += c[i] + d[i];
    }
  }
  std::swap(step_, nextStep_);
  smooth(x, false);
}

void TwoLevelCycle::smooth(double* x, bool wantsResidual) const
{
  const double sigma = centre_ / halfWidth_;
  double rho = 1.0 / sigma;
  for (int term = 1; term < degree; ++term) {
    const double before = std::exchange(rho, 1.0 / (2.0 * sigma - rho));
    const double along = rho * before, across = 2.0 * rho / halfWidth_;
    {
      const auto last = step_->getData(0);
      const auto next = nextStep_->getDataNonConst(0);
      const double* const d = last.getRawPtr();
      double* const e = next.getRawPtr();
      matrix_->multiply(*step_, product_.data());
      for (std::size_t i = 0; i < residual_.size(); ++i) {
        residual_[i] -= product_[i];
        e[i] = along * d[i] + across * inverseDiagonal_[i] * residual_[i];
        x[i] += e[i];
      }
    }
    std::swap(step_, nextStep_);
  }
  if (!wantsResidual)
    return;
  matrix_->multiply(*step_, product_.data());
  for (std::size_t i = 0; i < residual_.size(); ++i)
    residual_[i] -= product_[i];
}

CycleWork workOf(const FineOperator& matrix, const TwoLevelCycle& cycle)
{
  CycleWork work{matrix.products(), cycle.cycles(), matrix.traffic()};
  work.traffic += cycle.traffic();
  return work;
}

} // namespace ndframe

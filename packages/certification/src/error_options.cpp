#include "ndframe/certification/error_options.hpp"

#include <algorithm>

#include "ndframe/recovery/stress_recovery.hpp"

namespace ndframe
{
namespace
{

bool wantsAny(const ErrorOptions& options, std::initializer_list<Estimator> estimators)
{
  return std::any_of(estimators.begin(), estimators.end(), [&](Estimator e) { return options.wants(e); });
}

} // namespace

const Names<Estimator>& estimatorNames()
{
  static const Names<Estimator> names{{"Global", Estimator::Global},
                                      {"Algorithm", Estimator::Algorithm},
                                      {"Discretization", Estimator::Discretization},
                                      {"Split", Estimator::Split},
                                      {"Reference", Estimator::Reference},
                                      {"Zienkiewicz-Zhu", Estimator::ZienkiewiczZhu},
                                      {"Residual", Estimator::Residual}};
  return names;
}

const Names<ErrorMode>& errorModeNames()
{
  static const Names<ErrorMode> names{{"Strict", ErrorMode::Strict}, {"Paper", ErrorMode::Paper}};
  return names;
}

const Names<TractionType>& tractionTypeNames()
{
  static const Names<TractionType> names{{"Automatic", TractionType::Automatic},
                                         {"Optimal", TractionType::Optimal},
                                         {"Projected", TractionType::Projected}};
  return names;
}

const Names<TractionMean>& tractionMeanNames()
{
  static const Names<TractionMean> names{{"Previous", TractionMean::Previous}, {"Updated", TractionMean::Updated}};
  return names;
}

double EnoughBound::square(double norm) const
{
  constexpr double unknown = 1e-3; // to those who find bounds step by step
  const double bound = (1.0 - unknown) * value * (isRelative ? norm : 1.0);
  return bound * bound;
}

bool ErrorOptions::wants(Estimator estimator) const
{
  return std::find(estimators.begin(), estimators.end(), estimator) != estimators.end();
}

bool ErrorOptions::needsTraction() const
{
  return needsGlobalField() || (touches && wants(Estimator::Discretization));
}

bool ErrorOptions::needsGlobalField() const
{
  return touches && wantsAny(*this, {Estimator::Global, Estimator::Algorithm, Estimator::Split});
}

bool ErrorOptions::recoversStress() const
{
  return wantsAny(*this, {Estimator::Global, Estimator::Discretization, Estimator::Split});
}

bool ErrorOptions::recoversGlobalStress() const
{
  return wantsAny(*this, {Estimator::Global, Estimator::Split});
}

TractionType ErrorOptions::tractionWith(const StressRecovery& component, int dim) const
{
  if (tractionType != TractionType::Automatic)
    return tractionType;
  return component.optimises(dim) ? TractionType::Optimal : TractionType::Projected;
}

bool ErrorOptions::optimises(const StressRecovery& component, int dim) const
{
  return touches && recoversGlobalStress() && tractionWith(component, dim) == TractionType::Optimal;
}

} // namespace ndframe

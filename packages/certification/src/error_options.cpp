#include "ndframe/certification/error_options.hpp"

#include <algorithm>

#include "ndframe/base/list_specs.hpp"

namespace ndframe
{
namespace
{

ListSpec tractionSpec()
{
  ListSpec list;
  list.name = "Interface Traction";
  list.doc = "The admissible traction: pressing everywhere, equal on both bodies, in balance with the loads.";
  list.params = {
      {"Type", std::string("Optimal"), tractionTypeNames().range(),
       "Optimal: the one that makes the bound small, found by stars that span both bodies. Projected: the one nearest "
       "to the computed tractions (section 5.3 of the paper)."},
      {"Mean", std::string("Previous"), tractionMeanNames().range(),
       "Which traction of the Neumann side enters the mean of the two sides: Previous, with which its body is in "
       "equilibrium, or Updated, the one for the next sweep."}};
  return list;
}

ListSpec referenceSpec()
{
  ListSpec list;
  list.name = "Reference";
  list.doc = "The finer solution that the estimator Reference compares with: the same scene, all bodies at once.";
  list.params = {{"Refinements", 3, inClosedRange(1, 6), "Every edge is halved so many times; 3 gives h/8."},
                 {"Maximum Dofs", 2000000, atLeast(1),
                  "Refinement stops before the scene gets more dofs than this; the summary says so."}};
  return list;
}

bool wantsAny(const ErrorOptions& options, std::initializer_list<Estimator> estimators)
{
  return std::any_of(estimators.begin(), estimators.end(), [&](Estimator e) { return options.wants(e); });
}

std::vector<Estimator> requestedEstimators(const Params& list, bool touches)
{
  if (!list.has("Estimators"))
    return touches ? std::vector{Estimator::Global, Estimator::Algorithm, Estimator::Discretization}
                   : std::vector{Estimator::Global};
  std::vector<Estimator> estimators;
  for (const auto& name : list.get<std::vector<std::string>>("Estimators"))
    estimators.push_back(estimatorNames().value(name));
  return estimators;
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
  static const Names<TractionType> names{{"Optimal", TractionType::Optimal}, {"Projected", TractionType::Projected}};
  return names;
}

const Names<TractionMean>& tractionMeanNames()
{
  static const Names<TractionMean> names{{"Previous", TractionMean::Previous}, {"Updated", TractionMean::Updated}};
  return names;
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

bool ErrorOptions::optimises() const
{
  return touches && recoversGlobalStress() && tractionType == TractionType::Optimal;
}

bool estimatesErrors(const Params& deck)
{
  return deck.hasSub("Error Estimation");
}

ErrorOptions errorOptions(const Params& deck)
{
  const Params list = deck.sub("Error Estimation"), traction = list.sub("Interface Traction");
  const Params reference = list.sub("Reference");
  ErrorOptions options;
  options.touches = !deck.sub("Interfaces").subs().empty();
  options.estimators = requestedEstimators(list, options.touches);
  options.mode = errorModeNames().value(list.get<std::string>("Mode"));
  options.tractionType = tractionTypeNames().value(traction.get<std::string>("Type"));
  options.tractionMean = tractionMeanNames().value(traction.get<std::string>("Mean"));
  options.checkEquilibrium = list.get<bool>("Check Equilibrium");
  options.requireGuarantee = list.get<bool>("Require Guarantee");
  options.refinements = reference.get<int>("Refinements");
  options.maximumDofs = reference.get<int>("Maximum Dofs");
  return options;
}

ListSpec errorEstimationSpec(const Choices& recoveries)
{
  ListSpec list;
  list.name = "Error Estimation";
  list.doc = "How wrong the answer is: a guaranteed bound of the error in energy, and its parts. Without this list "
             "nothing of it runs.";
  list.onlyIfGiven = true;
  list.params = {
      ParamSpec::optional(
          "Estimators", Kind::Strings, estimatorNames().range(),
          "What is computed. Global: the bound. Algorithm and Discretization: what the stopped iteration and the mesh "
          "add (indicators). Split: the same two parts inside the bound. Reference: the error against a finer "
          "solution. Zienkiewicz-Zhu, Residual: comparisons without a guarantee. Without this key Global and, in decks "
          "with an interface, Algorithm and Discretization."),
      {"Mode", std::string("Strict"), errorModeNames().range(),
       "Strict: the displacement is made admissible between the nodes, so that the bound is one. Paper: as published, "
       "not guaranteed."},
      {"Check Equilibrium", false,
       "Look at the recovered stresses themselves: divergence, jumps, loads, contact. The bound's own decides about "
       "the "
       "guarantee; that of the indicator Discretization is only reported."},
      {"Require Guarantee", false, "A run whose bound is not guaranteed ends with exit code 3."}};
  list.lists = {makeChoice("Recovery", "How the stress in equilibrium with the loads is found.", recoveries),
                tractionSpec(), referenceSpec()};
  return list;
}

} // namespace ndframe

#include "error_list.hpp"

#include <utility>

#include <fmt/format.h>

#include "ndframe/base/list_specs.hpp"

namespace ndframe
{
namespace
{

ListSpec tractionSpec()
{
  ListSpec list;
  list.name = "Interface Traction";
  list.doc = "The admissible traction: compressive everywhere, equal on both bodies, in balance with the loads.";
  list.params = {
      {"Type", std::string("Automatic"), tractionTypeNames().range(),
       "Optimal: the one that makes the bound small: in 2D nearest to the solution in energy and then improved by "
       "stars that span both bodies (Recovery/Type Star), in 3D found together with the stresses (Global). "
       "Projected: the one nearest to the computed tractions in L2 (section 5.3 of the paper). Automatic: Optimal "
       "where the recovery can find it, otherwise Projected."},
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
  list.params = {{"Refinements", 3, inClosedRange(1, 6), "How many times every edge is halved; 3 gives h/8."},
                 {"Maximum Dofs", 0, atLeast(0),
                  "Refinement stops before the scene gets more dofs than this; the summary says so. 0: 2 000 000 in "
                  "2D, 400 000 in 3D."}};
  return list;
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

/// Adds mistakes of one list.
class Refusals
{
public:
  Refusals(const ListPlace& list, Diagnostics& diagnostics) : list_(list), diagnostics_(diagnostics) {}

  void when(bool isWrong, const std::string& key, const std::string& message)
  {
    if (isWrong)
      diagnostics_.add(list_.mistake(key, message));
  }

private:
  const ListPlace& list_;
  Diagnostics& diagnostics_;
};

void checkEstimators(const ErrorOptions& options, Diagnostics& diagnostics)
{
  Refusals refuse(options.place, diagnostics);
  refuse.when(options.estimators.empty(), "Estimators",
              "Estimators is empty; name what is wanted, or remove the list Error Estimation.");
  for (const auto part : {Estimator::Algorithm, Estimator::Discretization, Estimator::Split})
    refuse.when(options.wants(part) && !options.touches, "Estimators",
                fmt::format("\"{}\" is a part of the error of bodies in contact, and the deck has no interface; here "
                            "Global is the error of the mesh.",
                            estimatorNames().name(part)));
  const bool hasBound = options.wants(Estimator::Global);
  refuse.when(options.checkEquilibrium && !options.recoversStress(), "Check Equilibrium",
              "Check Equilibrium looks at the recovered stress, and no estimator recovers one; add \"Global\" to "
              "Estimators.");
  refuse.when(options.requireGuarantee && !hasBound, "Require Guarantee",
              "Require Guarantee asks for the bound; add \"Global\" to Estimators.");
  refuse.when(options.requireGuarantee && options.mode == ErrorMode::Paper, "Require Guarantee",
              "Mode = Paper uses a displacement that may penetrate between the nodes, so its number is not guaranteed; "
              "that of Mode = Strict is.");
}

void checkStressOutput(const OutputOptions& output, bool hasBound, Diagnostics& diagnostics)
{
  Refusals refuse(output.place, diagnostics);
  for (const auto& [isWanted, key] :
       {std::pair(output.equilibratedStress, "Equilibrated Stress"), std::pair(output.meanStress, "Mean Stress")})
    refuse.when(isWanted && !hasBound, key,
                fmt::format("{} is a result of the estimator Global; add it to Error Estimation/Estimators.", key));
}

} // namespace

ErrorOptions errorOptions(const Params& deck)
{
  const Params list = deck.sub("Error Estimation"), traction = list.sub("Interface Traction");
  const Params reference = list.sub("Reference");
  ErrorOptions options;
  options.place = ListPlace(list);
  options.touches = !deck.sub("Interfaces").subs().empty();
  options.estimators = requestedEstimators(list, options.touches);
  options.mode = errorModeNames().value(list.get<std::string>("Mode"));
  options.tractionType = tractionTypeNames().value(traction.get<std::string>("Type"));
  options.tractionMean = tractionMeanNames().value(traction.get<std::string>("Mean"));
  options.recoveryList = list.sub("Recovery");
  options.recovery = options.recoveryList.get<std::string>("Type");
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
  list.doc = "How wrong the answer is: a guaranteed bound on the error in energy, and its parts. Without this list "
             "none of this is computed.";
  list.onlyIfGiven = true;
  list.params = {
      ParamSpec::optional(
          "Estimators", Kind::Strings, estimatorNames().range(),
          "What is computed. Global: the bound. Algorithm and Discretization: what the stopped iteration and the mesh "
          "add (indicators). Split: the same two parts inside the bound. Reference: the error against a finer "
          "solution. Zienkiewicz-Zhu, Residual: comparisons without a guarantee. Without this key Global and, in decks "
          "with an interface, Algorithm and Discretization."),
      {"Mode", std::string("Strict"), errorModeNames().range(),
       "Strict: the displacement is made admissible between the nodes too, so that the bound is a true bound. Paper: "
       "as published, not guaranteed."},
      {"Check Equilibrium", false,
       "Check the recovered stresses themselves: divergence, jumps, loads, contact. That of the bound decides on the "
       "guarantee; that of the indicator Discretization is only reported."},
      {"Require Guarantee", false, "A run whose bound is not guaranteed ends with exit code 3."}};
  list.lists = {makeChoice("Recovery", "How the stress in equilibrium with the loads is found.", recoveries),
                tractionSpec(), referenceSpec()};
  return list;
}

void checkErrorEstimation(const std::optional<ErrorOptions>& errors, const OutputOptions& output,
                          Diagnostics& diagnostics)
{
  checkStressOutput(output, errors && errors->wants(Estimator::Global), diagnostics);
  if (errors)
    checkEstimators(*errors, diagnostics);
}

} // namespace ndframe

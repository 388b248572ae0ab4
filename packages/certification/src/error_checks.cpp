#include "ndframe/certification/error_checks.hpp"

#include <fmt/format.h>

namespace ndframe
{
namespace
{

/// Adds mistakes of one list.
class Refusals
{
public:
  Refusals(const Params& list, Diagnostics& diagnostics) : list_(list), diagnostics_(diagnostics) {}

  void when(bool isWrong, const std::string& key, const std::string& message)
  {
    if (isWrong)
      diagnostics_.add(list_.mistake(key, message));
  }

private:
  const Params& list_;
  Diagnostics& diagnostics_;
};

void checkEstimators(const ErrorOptions& options, const Params& list, Diagnostics& diagnostics)
{
  Refusals refuse(list, diagnostics);
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
  refuse.when(
      options.requireGuarantee && options.mode == ErrorMode::Paper, "Require Guarantee",
      "Mode = Paper takes a displacement that may penetrate between the nodes, so its number is not guaranteed; "
      "Mode = Strict is.");
}

void checkStressOutput(const Params& output, bool hasBound, Diagnostics& diagnostics)
{
  Refusals refuse(output, diagnostics);
  for (const auto* key : {"Equilibrated Stress", "Mean Stress"})
    refuse.when(output.get<bool>(key) && !hasBound, key,
                fmt::format("{} is a result of the estimator Global; add it to Error Estimation/Estimators.", key));
}

} // namespace

void checkErrorEstimation(const Params& deck, Diagnostics& diagnostics)
{
  const bool estimates = estimatesErrors(deck);
  checkStressOutput(deck.sub("Output"), estimates && errorOptions(deck).wants(Estimator::Global), diagnostics);
  if (estimates)
    checkEstimators(errorOptions(deck), deck.sub("Error Estimation"), diagnostics);
}

void checkRecovery(const Params& deck, const CertificateComponents& components, int dim, Diagnostics& diagnostics)
{
  if (!estimatesErrors(deck) || !errorOptions(deck).recoversStress())
    return;
  const Params list = deck.sub("Error Estimation").sub("Recovery");
  const int order = deck.sub("Discretization").get<int>("Order");
  const auto reason = components.recoveries.build(list)->refusal(dim, order, errorOptions(deck).optimises());
  Refusals(list, diagnostics).when(!reason.empty(), "", reason + ".");
}

} // namespace ndframe

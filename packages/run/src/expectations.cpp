#include <cmath>
#include <limits>
#include <regex>

#include <fmt/format.h>

#include "ndframe/run/summarize.hpp"
#include "probes.hpp"

namespace ndframe
{
namespace
{

/// Counts and seconds appear in the ledger only when something happened: absent means zero.
bool isLedgerPath(const std::string& path)
{
  return path.rfind("ledger/", 0) == 0;
}

/// Every number that the certificate will hold.
ErrorSummary everyError(const ErrorOptions& options)
{
  ErrorSummary errors;
  const auto fill = [&](Estimator estimator, auto&... numbers) {
    if (options.wants(estimator))
      (numbers.emplace(), ...);
  };
  fill(Estimator::Global, errors.global, errors.meanStress, errors.meanStressRelative);
  fill(Estimator::Algorithm, errors.algorithm);
  fill(Estimator::Discretization, errors.discretization);
  fill(Estimator::Split, errors.splitStress, errors.algorithm);
  fill(Estimator::ZienkiewiczZhu, errors.zienkiewiczZhu);
  fill(Estimator::Residual, errors.residual);
  fill(Estimator::Reference, errors.reference);
  fill(Estimator::Global, errors.energyBracket);
  if (errors.energyBracket) {
    errors.energyBracket->work.emplace();
    errors.energyBracket->drive.emplace();
  }
  if (options.checkEquilibrium && options.recoversGlobalStress())
    errors.equilibrium.emplace();
  if (options.checkEquilibrium)
    fill(Estimator::Discretization, errors.equilibriumDiscretization);
  if (errors.reference && errors.global) {
    auto& reference = *errors.reference;
    fill(Estimator::Reference, reference.stress, reference.meanStress, reference.effectivity,
         reference.meanStressEffectivity);
  }
  return errors;
}

/// The outline with one entry for what only the run can count: levels, sweeps, ends of the contact, components, errors.
RunSummary withEveryQuantity(RunSummary outline, const RunSettings& settings)
{
  if (settings.errors)
    outline.errors = everyError(*settings.errors);
  if (settings.accuracy) {
    outline.accuracy.emplace();
    outline.accuracy->levels.resize(1);
    outline.accuracy->levels.front().worstPoint = {0.0, 0.0};
    outline.accuracy->levels.front().dofsToTarget = 1;
    outline.accuracy->levels.front().energy.emplace();
  }
  if (outline.coupling)
    outline.coupling->history.resize(1);
  const std::vector<double> anyVector(outline.perUnitThickness ? 2 : 3, 0.0);
  for (auto& interface : outline.interfaces) {
    interface.endPoints.assign(2, {0.0, 0.0});
    interface.endBrackets.assign(2, {{0.0, 0.0}, {0.0, 0.0}});
    interface.forceOnDirichlet = interface.forceOnNeumann = anyVector;
  }
  for (auto& body : outline.bodies) {
    body.loadForce = body.displacement.point = body.strain.point = anyVector;
    for (auto& support : body.supports) {
      support.force = support.centre = anyVector;
      support.moment.assign(outline.perUnitThickness ? 1 : 3, 0.0);
    }
  }
  return outline;
}

/// "coupling/history/4/eps_tau" -> "coupling/history/0/eps_tau": any sweep and any level may be asked for.
std::string ofFirst(const std::string& path)
{
  static const std::regex numbered("^(coupling/history|accuracy/levels)/[0-9]+/");
  return std::regex_replace(path, numbered, "$1/0/");
}

} // namespace

bool isQuantity(const std::string& path, const RunSummary& outline, const RunSettings& settings)
{
  return isLedgerPath(path) || settings.numberOf(withEveryQuantity(outline, settings), ofFirst(path));
}

void checkWantedNumbers(const Model& model, const RunSettings& settings, const LinearSolver& solver,
                        Diagnostics& diagnostics)
{
  checkProbes(model, settings.output.probes, diagnostics);
  const RunSummary outline = outlineSummary(model, settings, solver, 1);
  for (const Expectation& expectation : settings.expectations) {
    const std::string& quantity = expectation.quantity;
    if (!isQuantity(quantity, outline, settings))
      diagnostics.add(expectation.place.mistake(
          "Quantity", fmt::format("\"{}\" is not a number in this run's summary; examples are \"energy\", "
                                  "\"bodies/{}/energy\", \"residuals/equilibrium\".",
                                  quantity, outline.bodies.front().name)));
  }
}

void checkExpectations(RunSummary& summary, const RunSettings& settings)
{
  for (const Expectation& expectation : settings.expectations) {
    ExpectationSummary result;
    result.name = expectation.name;
    const std::string& quantity = expectation.quantity;
    const double absent = isLedgerPath(quantity) ? 0.0 : std::numeric_limits<double>::quiet_NaN();
    result.value =
        settings.numberOf(summary, quantity).value_or(absent); // an absent number never meets its expectation
    result.expected = expectation.value;
    result.tolerance = expectation.tolerance;
    result.met = std::abs(result.value - result.expected) <= result.tolerance;
    summary.expectations.push_back(std::move(result));
  }
}

} // namespace ndframe

#include "verdict.hpp"

#include <cmath>

#include <fmt/format.h>

#include "ndframe/condensation/trust.hpp"
#include "ndframe/run/summarize.hpp"

namespace ndframe
{
namespace
{

/// Why a bound that the deck wants guaranteed is not; empty when it is or need not be.
std::string missingGuarantee(const std::optional<ErrorSummary>& errors, const RunSettings& settings)
{
  if (!errors || errors->guaranteed || !settings.errors->requireGuarantee)
    return {};
  return "the bound is not guaranteed: " + errors->reason;
}

/// A residual this many times the linear solver's tolerance is what the solver was asked for: its own is relative to
/// right-hand sides that cancel in part.
constexpr double amplification = 1e3;

/// Says that the linear solver was told to stop too early for forces in balance; empty when it was not.
std::string looseSolver(const RunSummary& summary, std::optional<double> tolerance)
{
  const double imbalance = summary.residuals.equilibrium;
  const bool explains =
      tolerance && imbalance > ResidualLimits().equilibrium && imbalance <= amplification * *tolerance;
  if (!explains)
    return {};
  return fmt::format("the forces are out of balance by {:.1e}, above the limit of {:g}: the linear solver's Tolerance "
                     "{:g} is too loose; lower it",
                     imbalance, ResidualLimits().equilibrium, *tolerance);
}

/// Why the numbers of a solution may not be trusted; empty when they may.
std::string doubtAbout(const RunSummary& summary, std::optional<double> solverTolerance)
{
  const auto reason = distrust(summary);
  const bool stoppedEarly = summary.coupling && !summary.coupling->converged;
  const auto loose = looseSolver(summary, solverTolerance);
  return reason.empty() || stoppedEarly || loose.empty() ? reason : loose;
}

} // namespace

std::string distrust(const RunSummary& summary)
{
  const bool boundDecides = summary.accuracy.has_value();
  if (summary.coupling && !summary.coupling->converged && !boundDecides)
    return summary.coupling->reason;
  if (!std::isfinite(summary.energy))
    return "the result is not a number";
  return passedLimit(summary.residuals);
}

std::string verdictOn(RunSummary& summary, const Solved& solved, const RunSettings& settings)
{
  const auto reason = summary.solved ? doubtAbout(summary, settings.solverTolerance) : solved.coupling.reason;
  if (reason.empty())
    return missingGuarantee(summary.errors, settings);
  if (summary.coupling) {
    summary.coupling->converged = false;
    summary.coupling->reason = reason;
  }
  return "not converged: " + reason;
}

} // namespace ndframe

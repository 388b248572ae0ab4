#include "stopping.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ndframe/algebra/dense.hpp"
#include "sweep.hpp"

namespace ndframe
{
namespace
{

constexpr double divergence = 1e30; ///< growth of the contact force that only an unstable iteration reaches
constexpr double clearly = 0.9;     ///< a fall by less than a tenth in half of all sweeps is none

/// All contact forces on the Dirichlet bodies press, so that their resultant is their size.
bool diverges(const std::vector<SweepRecord>& history)
{
  const auto first =
      std::find_if(history.begin(), history.end(), [](const SweepRecord& r) { return r.forceDirichlet != 0.0; });
  const double force = history.back().forceDirichlet;
  return !std::isfinite(force) ||
         (first != history.end() && std::abs(force) > divergence * std::abs(first->forceDirichlet));
}

/// What is to fall: the iteration's part of the error where it is measured, else eps_tau.
double watched(const SweepRecord& sweep)
{
  return sweep.iterationError.value_or(sweep.epsTau);
}

/// Whether the best sweep of the second half has clearly less of what is to fall than the best one before; one sweep
/// cannot tell. The best ones, because an iteration with too large a theta jumps to and fro.
bool isFalling(const std::vector<SweepRecord>& history)
{
  if (history.size() == 1)
    return true;
  const auto middle = history.begin() + std::ptrdiff_t((history.size() + 1) / 2);
  const auto smaller = [](const SweepRecord& a, const SweepRecord& b) { return watched(a) < watched(b); };
  return watched(*std::min_element(middle, history.end(), smaller)) <=
         clearly * watched(*std::min_element(history.begin(), middle, smaller));
}

bool overshoots(const std::vector<SweepRecord>& history)
{
  const auto middle = history.begin() + std::ptrdiff_t((history.size() + 1) / 2);
  return std::any_of(middle, history.end(), [](const SweepRecord& sweep) { return sweep.turned; });
}

Range toleranceRange()
{
  Range range = inOpenRange(0.0, 1.0);
  range.text = "in " + range.text + ": the first sweep from zero traction always has eps_tau = 2";
  return range;
}

} // namespace

double Stopping::measure(const Vector& dirichlet, const Vector& neumann)
{
  double difference = 0.0, sum = 0.0;
  double scale = 0.0;
  for (std::size_t i = 0; i < dirichlet.size(); ++i)
    scale = std::max({scale, std::abs(dirichlet[i]), std::abs(neumann[i])});
  if (scale == 0.0)
    return 0.0;
  for (std::size_t i = 0; i < dirichlet.size(); ++i) {
    difference += std::pow((dirichlet[i] - neumann[i]) / scale, 2);
    sum += std::pow((dirichlet[i] + neumann[i]) / scale, 2);
  }
  return 2.0 * std::sqrt(difference / sum);
}

Stopping Stopping::withGoal(double iterationError) const
{
  Stopping stopping = *this;
  stopping.iterationError_ = iterationError;
  return stopping;
}

bool Stopping::ends(CouplingResult& result, bool agree) const
{
  const SweepRecord& last = result.history.back();
  const bool hasGoal = iterationError_ > 0.0;
  const double value = hasGoal ? last.iterationError.value() : last.epsTau;
  const char* name = hasGoal ? "iteration" : "eps_tau";
  const std::string limit =
      hasGoal ? fmt::format("{:.3g} (energy norm)", iterationError_) : fmt::format("{:g}", tolerance_);
  const bool below = value < (hasGoal ? iterationError_ : tolerance_);
  result.converged = below || agree;
  if (areApart(last))
    result.reason = apart;
  else if (below)
    result.reason = fmt::format("{} {:.3g} < {}", name, value, limit);
  else if (agree)
    result.reason =
        fmt::format("the contact forces on both sides agree to round-off of the loads ({} {:.3g})", name, value);
  else if (diverges(result.history))
    result.reason = fmt::format("the iteration diverges (sweep {}); {}", last.sweep, advice_.text(true));
  else if (last.sweep >= maximumSweeps_)
    result.reason = fmt::format(
        "{} {:.3g} has not fallen below {} in {} sweeps (Maximum Sweeps){}", name, value, limit, maximumSweeps_,
        isFalling(result.history) ? "" : " and hardly falls; " + advice_.text(overshoots(result.history)));
  return !result.reason.empty();
}

Progress Stopping::progress(const SweepRecord& last) const
{
  return iterationError_ > 0.0
             ? Progress::falling("sweep", last.sweep, "iteration", last.iterationError.value(), iterationError_)
             : Progress::falling("sweep", last.sweep, "eps_tau", last.epsTau, tolerance_);
}

ListSpec Stopping::spec()
{
  ListSpec list;
  list.name = "Stopping";
  list.doc = "When the sweeps end.";
  list.params = {{"Tolerance", 0.01, toleranceRange(), "The iteration stops when eps_tau falls below this."},
                 {"Maximum Sweeps", 200, atLeast(1), "More sweeps than this count as not converged (exit code 3)."}};
  return list;
}

} // namespace ndframe

#include "ndframe/adaptivity/prediction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

/// Parts of a cell and what they leave of its squared contribution.
struct Parts
{
  double number, squared;
};

/// Of a cell at an edge; logRatio: log2 q.
double partsAtEdge(double exponent, double logRatio, ErrorDecay decay)
{
  const double growth = 2.0 * (decay.smoothExponent() - exponent) / decay.ofCell() - 2.0; // log2, from shell to shell
  const int last = int(logRatio / (2.0 * exponent + 1.0));
  double number = 0.0;
  for (int shell = 0; shell <= last; ++shell)
    number += (shell == last ? 1.0 : 0.75) * std::exp2(logRatio / decay.ofCell() + shell * growth);
  return number;
}

Parts partsAt(const CellDecay& cell, double level, ErrorDecay decay)
{
  const double smooth = decay.smoothExponent(), logRatio = cell.logSquared - level;
  if (cell.exponent == smooth || (decay.dim == 3 && logRatio <= 0.0)) {
    const int halvings = smoothHalvings(cell.logSquared, level, decay);
    return {std::exp2(halvings), std::exp2(cell.logSquared - decay.ofSum() * halvings)};
  }
  const double number = decay.dim == 3 ? partsAtEdge(cell.exponent, logRatio, decay)
                                       : smooth / cell.exponent * std::exp2(logRatio / smooth);
  if (number <= 1.0)
    return {1.0, std::exp2(cell.logSquared)};
  return {number, std::min(number * std::exp2(level), std::exp2(cell.logSquared))};
}

Parts sumAt(const std::vector<std::vector<CellDecay>>& cells, double level, ErrorDecay decay)
{
  Parts sum{0.0, 0.0};
  for (const auto& body : cells)
    for (const CellDecay& cell : body) {
      const Parts parts = partsAt(cell, level, decay);
      sum.number += parts.number;
      sum.squared += parts.squared;
    }
  return sum;
}

/// The levels that are tried lie whole binary fractions apart. Beginning at the largest contribution itself, its number
/// of halvings would be rounded at exactly n + 1/2, where round-off decides.
constexpr double awayFromHalves = 0.3;

} // namespace

Prediction predictRefinement(const std::vector<std::vector<CellDecay>>& cells, double target, ErrorDecay decay)
{
  NDFRAME_ASSERT(target > 0.0, "a prediction needs a positive target");
  const double smooth = decay.smoothExponent();
  double coarse = -std::numeric_limits<double>::infinity();
  for (const auto& body : cells)
    for (const CellDecay& cell : body)
      coarse = std::max(coarse, cell.logSquared + smooth * std::log2(smooth / cell.exponent));
  if (!std::isfinite(coarse))
    coarse = 0.0; // no cell contributes anything
  coarse += awayFromHalves;
  double fine = coarse;
  for (double step = 1.0; sumAt(cells, fine, decay).squared > target * target; step *= 2.0)
    fine -= step;
  constexpr double resolution = 1e-3; ///< of log2 tau^2: far below one halving
  while (coarse - fine > resolution) {
    const double middle = 0.5 * (fine + coarse);
    (sumAt(cells, middle, decay).squared <= target * target ? fine : coarse) = middle;
  }
  const Parts parts = sumAt(cells, fine, decay);
  return {fine, std::int64_t(std::ceil(parts.number)), std::sqrt(parts.squared)};
}

int smoothHalvings(double logSquared, double level, ErrorDecay decay)
{
  return int(std::max(0.0, std::round((logSquared - level) / decay.ofCell())));
}

} // namespace ndframe

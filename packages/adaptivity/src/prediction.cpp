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

Parts partsAt(const CellDecay& cell, double level, int degree)
{
  const double smooth = degree + 1.0;
  if (cell.exponent == smooth) {
    const int halvings = smoothHalvings(cell.logSquared, level, degree);
    return {std::exp2(halvings), std::exp2(cell.logSquared - degree * halvings)};
  }
  const double number = smooth / cell.exponent * std::exp2((cell.logSquared - level) / smooth);
  if (number <= 1.0)
    return {1.0, std::exp2(cell.logSquared)};
  return {number, std::min(number * std::exp2(level), std::exp2(cell.logSquared))};
}

Parts sumAt(const std::vector<std::vector<CellDecay>>& cells, double level, int degree)
{
  Parts sum{0.0, 0.0};
  for (const auto& body : cells)
    for (const CellDecay& cell : body) {
      const Parts parts = partsAt(cell, level, degree);
      sum.number += parts.number;
      sum.squared += parts.squared;
    }
  return sum;
}

/// The levels that are tried lie whole binary fractions apart. Beginning at the largest contribution itself, its number
/// of halvings would be rounded at exactly n + 1/2, where round-off decides.
constexpr double awayFromHalves = 0.3;

} // namespace

Prediction predictRefinement(const std::vector<std::vector<CellDecay>>& cells, double target, int degree)
{
  NDFRAME_ASSERT(target > 0.0, "a prediction needs a positive target");
  double coarse = -std::numeric_limits<double>::infinity();
  for (const auto& body : cells)
    for (const CellDecay& cell : body)
      coarse = std::max(coarse, cell.logSquared + (degree + 1) * std::log2((degree + 1) / cell.exponent));
  if (!std::isfinite(coarse))
    coarse = 0.0; // no cell contributes anything
  coarse += awayFromHalves;
  double fine = coarse;
  for (double step = 1.0; sumAt(cells, fine, degree).squared > target * target; step *= 2.0)
    fine -= step;
  constexpr double resolution = 1e-3; ///< of log2 tau^2: far below one halving
  while (coarse - fine > resolution) {
    const double middle = 0.5 * (fine + coarse);
    (sumAt(cells, middle, degree).squared <= target * target ? fine : coarse) = middle;
  }
  const Parts parts = sumAt(cells, fine, degree);
  return {fine, std::int64_t(std::ceil(parts.number)), std::sqrt(parts.squared)};
}

int smoothHalvings(double logSquared, double level, int degree)
{
  return int(std::max(0.0, std::round((logSquared - level) / (degree + 1))));
}

} // namespace ndframe

#include "ndframe/estimation/energy_bracket.hpp"

#include <algorithm>
#include <cmath>

namespace ndframe
{
namespace
{

/// Sums over all cells and dofs are right to this, relative to their terms.
constexpr double lastDigits = 1e-11;

} // namespace

EnergyBracket bracketEnergy(const ErrorMeasure& measure, double strainEnergy, double work, double imbalance)
{
  const double energy = 0.5 * strainEnergy - work, l = measure.prescribed;
  const double charge = std::sqrt(std::max(strainEnergy, 0.0)) * l, width = measure.widened + l;
  EnergyBracket bracket;
  bracket.upper = energy + charge + 0.5 * l * l;
  bracket.lower = energy - charge + 0.5 * l * l - 0.5 * (width * width + measure.contact);
  bracket.roundOff = (lastDigits + imbalance) * (0.5 * strainEnergy + std::abs(work));
  return bracket;
}

std::optional<Contradiction> EnergyRecord::add(const EnergyBracket& bracket, const std::string& name)
{
  std::optional<Contradiction> found;
  if (bracket.lower - upper_.value > bracket.roundOff + upper_.roundOff)
    found = Contradiction{upper_.name, name, bracket.lower, upper_.value, true};
  else if (lower_.value - bracket.upper > bracket.roundOff + lower_.roundOff)
    found = Contradiction{lower_.name, name, lower_.value, bracket.upper, false};
  if (bracket.lower > lower_.value)
    lower_ = {bracket.lower, bracket.roundOff, name};
  if (bracket.upper < upper_.value)
    upper_ = {bracket.upper, bracket.roundOff, name};
  ++certificates_;
  holds_ = holds_ && !found;
  return found;
}

} // namespace ndframe

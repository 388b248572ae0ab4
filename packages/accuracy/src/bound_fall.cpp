#include "ndframe/accuracy/bound_fall.hpp"

#include <algorithm>
#include <cmath>

namespace ndframe
{

double BoundFall::power() const
{
  return isProportional() ? 1.0 : power_;
}

double BoundFall::expected(double before, double predicted) const
{
  if (isProportional())
    return factor_ * predicted;
  return inSpace_ ? before * std::pow(predicted / before, power_) : predicted;
}

double BoundFall::predicted(double before, double wanted) const
{
  if (isProportional())
    return wanted / factor_;
  return inSpace_ ? before * std::pow(wanted / before, 1.0 / power_) : wanted;
}

void BoundFall::learn(double before, double predicted, double found)
{
  if (isProportional()) {
    constexpr double kept = 0.75, smallest = 0.85, largest = 1.3; // of its logarithm; of the factor
    factor_ = std::clamp(std::pow(found / predicted, kept), smallest, largest);
    return;
  }
  if (!inSpace_ || predicted >= before)
    return;
  constexpr double least = 0.4;
  const double last = std::log(found / before) / std::log(predicted / before);
  power_ = std::clamp(0.5 * (last + (knowsEdges_ ? 1.0 : power_)), least, most_);
}

void BoundFall::edgesBecameKnown()
{
  constexpr double atFirst = 0.75;
  power_ = std::max(power_, atFirst);
  knowsEdges_ = true;
}

} // namespace ndframe

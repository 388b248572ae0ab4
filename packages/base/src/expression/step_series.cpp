#include "step_series.hpp"

namespace ndframe
{
namespace
{

constexpr Interval yes{1.0, 1.0}, no{0.0, 0.0}, open{0.0, 1.0};

} // namespace

Interval comparison(Operation operation, Interval a)
{
  if (a.lo == a.hi) {
    const double value = valueOf(operation, a.lo, 0.0, 0.0);
    return {value, value};
  }
  const bool isNegative = a.hi <= 0.0, isPositive = a.lo >= 0.0;
  switch (operation) {
  case Operation::IsNegative:
  case Operation::IsNonPositive:
    return isNegative ? yes : isPositive ? no : open;
  case Operation::IsPositive:
  case Operation::IsNonNegative:
    return isPositive ? yes : isNegative ? no : open;
  case Operation::IsZero:
    return isNegative || isPositive ? no : open;
  default:
    return isNegative || isPositive ? yes : open;
  }
}

Interval truth(Interval a)
{
  return !a.contains(0.0) ? yes : a.isZero() ? no : open;
}

Series constantOn(Interval range)
{
  return range.lo == range.hi ? constant(range) : onlyRange(range);
}

} // namespace ndframe

#pragma once

#include <algorithm>
#include <vector>

namespace ndframe
{

/// The place of a number among ascending ones; -1: it is none of them.
template <class Number>
int placeOf(const std::vector<Number>& ascending, Number number)
{
  const auto found = std::lower_bound(ascending.begin(), ascending.end(), number);
  return found != ascending.end() && *found == number ? int(found - ascending.begin()) : -1;
}

} // namespace ndframe

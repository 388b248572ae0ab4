#pragma once

#include <algorithm>
#include <type_traits>
#include <vector>

namespace ndframe
{

/// The place of a number (of any type with an order) among ascending ones; -1: it is none of them.
template <class Number>
int placeOf(const std::vector<Number>& ascending, Number number)
{
  if constexpr (std::is_integral_v<Number>) // most follow one another
    if (!ascending.empty() && number >= ascending.front() &&
        std::size_t(number - ascending.front()) < ascending.size() &&
        ascending[std::size_t(number - ascending.front())] == number)
      return int(number - ascending.front());
  const auto found = std::lower_bound(ascending.begin(), ascending.end(), number);
  return found != ascending.end() && *found == number ? int(found - ascending.begin()) : -1;
}

} // namespace ndframe

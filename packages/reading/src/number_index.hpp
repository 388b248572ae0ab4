#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "ndframe/reading/file_error.hpp"

namespace ndframe
{

/// Numbers that a file gives to its nodes -> their positions, for numbers in any order and with gaps.
class NumberIndex
{
public:
  /// Throws FileError when a number occurs twice.
  explicit NumberIndex(const std::vector<std::int64_t>& numbers)
  {
    for (std::size_t i = 0; i < numbers.size(); ++i)
      sorted_.push_back({numbers[i], int(i)});
    std::sort(sorted_.begin(), sorted_.end());
    const auto twice = std::adjacent_find(sorted_.begin(), sorted_.end(),
                                          [](const auto& a, const auto& b) { return a.first == b.first; });
    if (twice != sorted_.end())
      throw FileError(fmt::format("node {} is given twice.", twice->first));
  }

  /// -1 for a number that does not exist.
  int find(std::int64_t number) const
  {
    // Numbers without gaps, the usual case, are found at once.
    const auto guess = sorted_.empty() ? std::uint64_t(0) : std::uint64_t(number) - std::uint64_t(sorted_[0].first);
    if (guess < sorted_.size() && sorted_[guess].first == number)
      return sorted_[guess].second;
    const auto found = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair{number, 0});
    return found != sorted_.end() && found->first == number ? found->second : -1;
  }

private:
  std::vector<std::pair<std::int64_t, int>> sorted_;
};

} // namespace ndframe

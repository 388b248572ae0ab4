#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <numeric>
#include <vector>

namespace ndframe
{

using NumberPair = std::array<std::int64_t, 2>;

/// Pairs of cells ascending, what belongs to them in their order, whoever sent it; each once.
template <class Value>
std::vector<NumberPair> inOrder(const std::vector<NumberPair>& pairs, std::vector<Value>& values)
{
  if (std::adjacent_find(pairs.begin(), pairs.end(), std::greater_equal<>()) == pairs.end())
    return pairs;
  std::vector<int> order(pairs.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return pairs[std::size_t(a)] < pairs[std::size_t(b)]; });
  std::vector<NumberPair> ascending;
  std::vector<Value> sorted;
  ascending.reserve(pairs.size());
  sorted.reserve(pairs.size());
  for (const int at : order) {
    if (!ascending.empty() && ascending.back() == pairs[std::size_t(at)])
      continue;
    ascending.push_back(pairs[std::size_t(at)]);
    sorted.push_back(values[std::size_t(at)]);
  }
  values = std::move(sorted);
  return ascending;
}

} // namespace ndframe

#include <algorithm>
#include <numeric>

#include "ndframe/mesh/partition.hpp"

namespace ndframe
{
namespace
{

using Points = std::vector<std::array<double, 3>>;

std::size_t longestExtent(const Points& points, const std::vector<int>& order, std::size_t begin, std::size_t end)
{
  std::array<double, 3> extent{};
  for (std::size_t k = 0; k < extent.size() && begin < end; ++k) {
    double low = points[std::size_t(order[begin])][k], high = low;
    for (std::size_t i = begin; i < end; ++i) {
      low = std::min(low, points[std::size_t(order[i])][k]);
      high = std::max(high, points[std::size_t(order[i])][k]);
    }
    extent[k] = high - low;
  }
  return std::size_t(std::max_element(extent.begin(), extent.end()) - extent.begin());
}

/// Shares out order[begin] .. order[end - 1] among `parts` ranks from `first` on.
void share(const Points& points, std::vector<int>& order, std::size_t begin, std::size_t end, int first, int parts,
           std::vector<int>& owner)
{
  if (parts == 1) {
    for (std::size_t i = begin; i < end; ++i)
      owner[std::size_t(order[i])] = first;
    return;
  }
  const int below = parts / 2;
  const std::size_t middle = begin + (end - begin) * std::size_t(below) / std::size_t(parts);
  const std::size_t k = longestExtent(points, order, begin, end);
  const auto at = [&](std::size_t i) { return order.begin() + std::ptrdiff_t(i); };
  std::nth_element(at(begin), at(middle), at(end), [&](int a, int b) {
    const double x = points[std::size_t(a)][k], y = points[std::size_t(b)][k];
    return x < y || (x == y && a < b);
  });
  share(points, order, begin, middle, first, below, owner);
  share(points, order, middle, end, first + below, parts - below, owner);
}

} // namespace

std::vector<int> partitionByPlace(const std::vector<std::array<double, 3>>& points, int parts)
{
  std::vector<int> owner(points.size(), 0), order(points.size());
  std::iota(order.begin(), order.end(), 0);
  share(points, order, 0, points.size(), 0, parts, owner);
  return owner;
}

} // namespace ndframe

#include "block_grid.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/algebra/shared_values.hpp"

namespace ndframe
{

BlockGrid::BlockGrid(const std::vector<Direction>& places, int perBlock, int most, const Comm& comm)
{
  Vector low(3, HUGE_VAL), high(3, -HUGE_VAL);
  for (const Direction& place : places)
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], place[i]);
      high[i] = std::max(high[i], place[i]);
    }
  takeExtremes(low, high, comm);
  const std::int64_t all = comm.sum(std::int64_t(places.size()));
  const auto blocks = double(std::clamp<std::int64_t>(all / perBlock, 1, most));
  for (std::size_t i = 0; i < 3; ++i) {
    low_[i] = low[i];
    extent_[i] = std::max(0.0, high[i] - low[i]);
  }
  Direction longest = extent_;
  std::sort(longest.rbegin(), longest.rend());
  double size = longest[0]; // of a box; it divides the directions that are longer
  for (int directions = 3; directions > 0; --directions) {
    double product = 1.0;
    for (int i = 0; i < directions; ++i)
      product *= longest[std::size_t(i)];
    size = std::pow(product / blocks, 1.0 / directions);
    if (longest[std::size_t(directions) - 1] >= size)
      break;
  }
  for (std::size_t i = 0; i < 3; ++i)
    if (size > 0.0)
      count_[i] = std::max(1, int(extent_[i] / size + 0.5));
}

int BlockGrid::blockOf(const Direction& place) const
{
  int block = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double part = extent_[i] > 0.0 ? (place[i] - low_[i]) / extent_[i] : 0.0;
    block = block * count_[i] + std::clamp(int(part * count_[i]), 0, count_[i] - 1);
  }
  return block;
}

} // namespace ndframe

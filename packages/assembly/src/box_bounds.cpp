#include "box_bounds.hpp"

#include <cmath>

namespace ndframe
{

const Enclosure& BoxBounds::around(const Region::Point& centroid, double radius)
{
  int level = 0;
  std::frexp(radius, &level); // radius <= 2^level
  const double width = std::ldexp(1.0, level + 3), largest = std::ldexp(1.0, level);
  std::array<std::int64_t, 3> cell{};
  Region::Point middle{};
  for (std::size_t k = 0; k < std::size_t(space_); ++k) {
    const double number = std::floor(centroid[k] / width);
    cell[k] = std::int64_t(std::clamp(number, -9e18, 9e18));
    middle[k] = (number + 0.5) * width;
  }
  const Place place{level, cell[0], cell[1], cell[2]};
  if (ofLast_ != nullptr && place == last_)
    return *ofLast_;
  const auto [found, isNew] = boxes_.try_emplace(place);
  if (isNew)
    found->second = enclose(tree_, Region::box(space_, middle, 0.5 * width + largest, largest));
  last_ = place;
  ofLast_ = &found->second;
  return *ofLast_;
}

} // namespace ndframe

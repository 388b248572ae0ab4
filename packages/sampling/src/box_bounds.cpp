#include "box_bounds.hpp"

#include <cmath>

namespace ndframe
{

TreeBox::TreeBox(const Region::Point& x, int level, int space) : width(std::ldexp(1.0, level))
{
  std::array<std::int64_t, 3> cell{};
  for (std::size_t k = 0; k < std::size_t(space); ++k) {
    const double number = std::floor(x[k] / width);
    cell[k] = std::int64_t(std::clamp(number, -9e18, 9e18));
    middle[k] = (number + 0.5) * width;
  }
  place = {level, cell[0], cell[1], cell[2]};
}

int TreeBox::levelOf(double radius)
{
  int level = 0;
  std::frexp(radius, &level);
  return level;
}

const Enclosure& BoxBounds::around(const Region::Point& centroid, double radius)
{
  const int level = TreeBox::levelOf(radius);
  const TreeBox box(centroid, level + 3, space_);
  if (ofLast_ != nullptr && box.place == last_)
    return *ofLast_;
  const auto [found, isNew] = boxes_.try_emplace(box.place);
  const double largest = std::ldexp(1.0, level);
  if (isNew)
    found->second = enclose(tree_, Region::box(space_, box.middle, 0.5 * box.width + largest, largest));
  last_ = box.place;
  ofLast_ = &found->second;
  return *ofLast_;
}

} // namespace ndframe

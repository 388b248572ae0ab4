#include "ndframe/adaptivity/size_field.hpp"

#include <algorithm>
#include <cmath>

namespace ndframe
{

double CellSize::logAreaAt(const std::array<double, 3>& point) const
{
  if (gradation == 0.0)
    return std::max(leastLogArea, logArea);
  const double x = point[0] - corner[0], y = point[1] - corner[1];
  return std::max(leastLogArea, logArea + gradation * std::log2(x * x + y * y));
}

int halvingsTo(const CellSize& size, double area, const std::array<double, 3>& centre)
{
  return int(std::max(0.0, std::round(std::log2(area) - size.logAreaAt(centre))));
}

} // namespace ndframe

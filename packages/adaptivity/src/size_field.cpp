#include "ndframe/adaptivity/size_field.hpp"

#include <algorithm>
#include <cmath>

namespace ndframe
{

double CellSize::logMeasureAt(const std::array<double, 3>& point) const
{
  if (gradation == 0.0)
    return std::max(leastLogMeasure, logMeasure);
  return std::max(leastLogMeasure, logMeasure + gradation * std::log2(place.squaredDistance(point)));
}

int halvingsTo(const CellSize& size, double measure, const std::array<double, 3>& centre)
{
  return int(std::max(0.0, std::round(std::log2(measure) - size.logMeasureAt(centre))));
}

} // namespace ndframe

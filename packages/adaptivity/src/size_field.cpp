#include "ndframe/adaptivity/size_field.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

/// Of a facet's length: as far from the segment its middle may be, and as much it may stand out at an end of it.
constexpr double besides = 0.25, beyond = 0.49;

} // namespace

double FineSegment::facetOn(const Mesh& mesh, int cell) const
{
  NDFRAME_ASSERT(mesh.dim == 2, "segments are of the plane");
  const double way[2] = {to[0] - from[0], to[1] - from[1]}, length = std::hypot(way[0], way[1]);
  double longestOn = 0.0;
  for (int local = 0; local < 3; ++local) {
    const double* one = mesh.point(mesh.cell(cell)[(local + 1) % 3]);
    const double* other = mesh.point(mesh.cell(cell)[(local + 2) % 3]);
    const double middle[2] = {0.5 * (one[0] + other[0]) - from[0], 0.5 * (one[1] + other[1]) - from[1]};
    const double facet = std::hypot(one[0] - other[0], one[1] - other[1]);
    const double along = (middle[0] * way[0] + middle[1] * way[1]) / length;
    const double apart = std::abs(middle[0] * way[1] - middle[1] * way[0]) / length;
    if (apart < besides * facet && along > -beyond * facet && along < length + beyond * facet)
      longestOn = std::max(longestOn, facet);
  }
  return longestOn;
}

double CellSize::logMeasureAt(const std::array<double, 3>& point) const
{
  if (gradation == 0.0)
    return std::max(leastLogMeasure, logMeasure);
  return std::max(leastLogMeasure, logMeasure + gradation * std::log2(place.squaredDistance(point)));
}

int halvingsTo(const CellSize& size, const Mesh& mesh, int part)
{
  const double halvings = std::log2(cellMeasure(mesh, part)) - size.logMeasureAt(cellCentre(mesh, part));
  const bool isCoarse = std::any_of(size.fine.begin(), size.fine.end(), [&](const FineSegment& segment) {
    return segment.facetOn(mesh, part) > segment.longest;
  });
  return int(std::max(isCoarse ? 1.0 : 0.0, std::round(halvings)));
}

} // namespace ndframe

#pragma once

#include <array>

namespace ndframe
{

/// Where stresses are infinite or nearly so: a corner, or in space the straight edge through a point.
struct SingularPlace
{
  std::array<double, 3> point{};     ///< the corner, or any point of the edge
  std::array<double, 3> direction{}; ///< unit vector of the edge; zero: a corner

  /// From the corner, or from the straight line through the edge.
  double squaredDistance(const std::array<double, 3>& x) const
  {
    const double d[3] = {x[0] - point[0], x[1] - point[1], x[2] - point[2]};
    const double along = d[0] * direction[0] + d[1] * direction[1] + d[2] * direction[2];
    return d[0] * d[0] + d[1] * d[1] + d[2] * d[2] - along * along;
  }
};

} // namespace ndframe

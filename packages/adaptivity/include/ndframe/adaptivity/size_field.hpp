#pragma once

#include <array>
#include <vector>

namespace ndframe
{

/// Wanted areas of the parts of one cell: the same everywhere, or falling towards a corner at x_c like |x - x_c|^(2 g).
struct CellSize
{
  double logArea;         ///< log2 of the area; with a gradation, at the distance 1 from the corner
  double gradation = 0.0; ///< g
  double leastLogArea;    ///< nothing smaller, however near the corner
  std::array<double, 3> corner{};

  double logAreaAt(const std::array<double, 3>& point) const;
};

/// Per body and cell of its present mesh.
using SizeField = std::vector<std::vector<CellSize>>;

/// How often a part is to be halved, rounded: log2(area / wanted area), not negative. centre: of the part.
int halvingsTo(const CellSize& size, double area, const std::array<double, 3>& centre);

} // namespace ndframe

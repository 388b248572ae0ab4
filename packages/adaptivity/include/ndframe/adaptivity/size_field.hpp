#pragma once

#include <array>
#include <vector>

#include "ndframe/adaptivity/singular_place.hpp"

namespace ndframe
{

/// Wanted measures (areas, volumes) of the parts of one cell: the same everywhere, or falling towards a corner or edge
/// like d^(2 g), d the distance from it.
struct CellSize
{
  double logMeasure;      ///< log2 of the measure; with a gradation, at the distance 1
  double gradation = 0.0; ///< g
  double leastLogMeasure; ///< nothing smaller, however near the place
  SingularPlace place{};

  double logMeasureAt(const std::array<double, 3>& point) const;
};

/// Per body and cell of its present mesh.
using SizeField = std::vector<std::vector<CellSize>>;

/// How often a part is to be halved, rounded: log2(measure / wanted measure), not negative. centre: of the part.
int halvingsTo(const CellSize& size, double measure, const std::array<double, 3>& centre);

} // namespace ndframe

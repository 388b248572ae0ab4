#pragma once

#include <array>
#include <vector>

#include "ndframe/adaptivity/singular_place.hpp"
#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// A piece of a straight line of the plane on which facets are to be short, whatever else is wanted.
struct FineSegment
{
  /// Where it begins.
  std::array<double, 2> from{}, to{}; ///< where it ends
  double longest;                     ///< of the facets on it

  /// The length of the cell's longest facet that lies on a piece of it, or as near as chords of a curve do; 0: none.
  double facetOn(const Mesh& mesh, int cell) const;
};

/// Wanted measures (areas, volumes) of the parts of one cell: the same everywhere, or falling towards a corner or edge
/// like d^(2 g), d the distance from it.
struct CellSize
{
  double logMeasure;               ///< log2 of the measure; with a gradation, at the distance 1
  double gradation = 0.0;          ///< g
  double leastLogMeasure;          ///< nothing smaller, however near the place
  SingularPlace place{};           ///< from which d is measured; unused without a gradation
  std::vector<FineSegment> fine{}; ///< that parts may have facets on

  double logMeasureAt(const std::array<double, 3>& point) const; ///< for the part with this centre
  /// Whether all parts are to have the same measure.
  bool isEven() const { return gradation == 0.0 && fine.empty(); }
};

/// Per body and cell of its present mesh.
using SizeField = std::vector<std::vector<CellSize>>;

/// How often a part, a cell of the mesh, is to be halved, rounded: log2(measure / wanted measure), not negative; at
/// least once where its facet on a fine segment is too long.
int halvingsTo(const CellSize& size, const Mesh& mesh, int part);

} // namespace ndframe

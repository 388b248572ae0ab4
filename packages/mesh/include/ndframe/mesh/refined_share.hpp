#pragma once

#include <string>
#include <vector>

#include "ndframe/mesh/refined_numbers.hpp"

namespace ndframe
{

/// Who owns the points of a drawn mesh however often it is refined: what lies inside an edge, facet or cell goes with
/// the vertex that comes first among its own.
struct DrawnOwners
{
  std::vector<int> order; ///< per drawn vertex; vertices of two bodies that touch each other have the same
  std::vector<int> ranks; ///< per drawn vertex; the same for the same order

  int rankOf(const DrawnPlace& place) const; ///< the owner of a point
};

/// What a rank has of a mesh that is refined after it has been shared out.
struct RefinedShare
{
  /// The cells with a node of the rank (a point or the middle of an edge), and those that touch the sides that all
  /// ranks have. Points ascend by `numbers`, facets of sides come as in the whole mesh: two ranks have what both have
  /// in the same order. Every side of the drawn mesh is there, perhaps without facets.
  Mesh mesh;
  std::vector<DrawnPlace> points;                  ///< per point of `mesh`
  std::vector<RefinedNumbers::Number> numbers;     ///< per point of `mesh`: that of the whole mesh
  std::vector<RefinedNumbers::Number> cellNumbers; ///< per cell: that of the whole mesh
  std::vector<int> cellOwners;                     ///< per cell, the rank
  int numOwnCells = 0;                             ///< the first ones: each cell of the whole mesh is one rank's
};

/// The rank's share of the drawn mesh with its edges halved so many times (refineUniformly), made without the rest of
/// the refined mesh. sides: names of those that all ranks have, with the cells that touch them. A cell is its lowest
/// point's owner's. withHalo: and all cells that have a vertex in common with an own one.
RefinedShare refinedShare(const Mesh& drawn, int halvings, const RefinedNumbers& numbers, const DrawnOwners& owners,
                          int rank, const std::vector<std::string>& sides, bool withHalo = false);

/// Per point whether it lies on one of these sides, which the mesh has.
std::vector<char> pointsOfSides(const Mesh& mesh, const std::vector<std::string>& sides);

} // namespace ndframe

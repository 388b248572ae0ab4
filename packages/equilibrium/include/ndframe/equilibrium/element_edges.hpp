#pragma once

#include <vector>

#include "ndframe/assembly/body_system.hpp"
#include "ndframe/equilibrium/moment_basis.hpp"

namespace ndframe
{

/// The triangles of a mesh joined across their edges (half edges: facet_twins.hpp).
struct EdgeMap
{
  std::vector<SortedCell> cells;
  std::vector<int> twin;  ///< per half edge: the same edge in the neighbour; -1 on the boundary
  std::vector<int> start; ///< per vertex: a half edge at it, one on the boundary if there is any

  bool onBoundary(int half) const { return twin[std::size_t(half)] < 0; }
};

/// Refuses (SelfTouching) a body that touches itself in a point: the forces at its parts there are not in
/// balance one by one.
EdgeMap edgeMap(const BodyModel& body);

/// Place of a vertex (sorted number in the cell) among the two vertices of a half edge, ascending.
inline int placeOnEdge(int half, int corner)
{
  return corner > half % 3 ? corner - 1 : corner;
}

/// A cell on the way round one of its vertices.
struct FanCell
{
  int cell, corner; ///< corner: sorted number of the vertex
  int in, out;      ///< half edges at the vertex by which the cell is entered and left
};

/// The cells of a vertex in turn; `in` of each is the twin of `out` of the one before.
struct EdgeFan
{
  std::vector<FanCell> cells;
  bool closed = false; ///< the last one leads back to the first; else both ends are boundary edges
};

EdgeFan fanAround(const EdgeMap& edges, int vertex);

} // namespace ndframe

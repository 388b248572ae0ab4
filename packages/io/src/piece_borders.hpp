#pragma once

#include <vector>

#include "ndframe/fem/node_map.hpp"

namespace ndframe
{

/// What a piece of a body has together with another piece.
struct PieceBorder
{
  int other;                 ///< number of the other piece
  std::vector<int> nodes;    ///< of the body, ascending
  std::vector<Facet> facets; ///< of this piece's cells, numbered in the body; ordered by their vertices
};

/// The borders of a piece with every other that has a node of its cells, ascending by `other`. The order of nodes and
/// facets is the same when both pieces are asked. owner: per cell its piece.
std::vector<PieceBorder> bordersOf(const NodeMap& nodes, const std::vector<int>& owner, int piece);

} // namespace ndframe

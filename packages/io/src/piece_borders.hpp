#pragma once

#include <vector>

#include "ndframe/io/piece_border.hpp"

namespace ndframe
{

/// The borders of a piece with every other that has a node of its cells, ascending by `other`. The order of nodes and
/// facets is the same when both pieces are asked. owner: per cell its piece.
std::vector<PieceBorder> bordersOf(const NodeMap& nodes, const std::vector<int>& owner, int piece);

} // namespace ndframe

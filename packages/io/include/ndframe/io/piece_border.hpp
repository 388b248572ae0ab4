#pragma once

#include <cstdint>
#include <vector>

#include "ndframe/algebra/comm.hpp"
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

/// A body of which a process has a share.
struct SharedNodes
{
  const NodeMap& nodes;                     ///< of the share
  const std::vector<std::int64_t>& numbers; ///< per node of the share: its number in the whole body, ascending
  const std::vector<int>& owners;           ///< per node of the share: the process that answers for it
  int numOwnCells;                          ///< the first cells of the share are the process's own, its piece
};

/// The borders of this process's piece with those of all others that have a node of its cells, ascending by `other`.
/// All processes have the same order, by numbers in the whole body. Each node's owner is told which pieces have it, and
/// tells them; pieces that have all nodes of a facet in common compare what they have. Collective.
std::vector<PieceBorder> bordersOfShare(const SharedNodes& share, const Comm& comm);

} // namespace ndframe

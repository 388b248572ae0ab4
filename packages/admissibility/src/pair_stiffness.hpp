#pragma once

#include "interface_pairs.hpp"

namespace ndframe
{

/// Movements of pairs of interface nodes against each other by a unit opening, and their stiffness a(m_i, m_j).
struct PairMoves
{
  std::size_t dim = 2;
  std::vector<Pair> pairs;
  std::vector<Compliance> moves;                         ///< opens its patches by 1, at corners by 1 at least
  std::vector<std::vector<std::pair<int, double>>> rows; ///< of the stiffness, by pair
  std::map<int, int> index;                              ///< of interface nodes

  /// Work of nodal forces (per body, global axes) on move i.
  double work(int i, const std::vector<NodalField>& forces) const;
};

/// Pairs that supports hold on both sides are left out.
PairMoves pairMoves(const std::vector<ContactPatch>& patches, InterfacePairs& pairs);

} // namespace ndframe

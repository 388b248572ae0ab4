#pragma once

#include <vector>

#include "ndframe/algebra/comm.hpp"
#include "ndframe/assembly/side_condition.hpp"

namespace ndframe
{

/// Boxes of equal size around places that the ranks have, each of them some; the same on all ranks, however the places
/// are shared.
class BlockGrid
{
public:
  /// perBlock: so many places in a box, about; most: boxes. Collective.
  BlockGrid(const std::vector<Direction>& places, int perBlock, int most, const Comm& comm);

  int size() const { return count_[0] * count_[1] * count_[2]; }
  int blockOf(const Direction& place) const;

private:
  Direction low_{}, extent_{};
  std::array<int, 3> count_{1, 1, 1};
};

} // namespace ndframe

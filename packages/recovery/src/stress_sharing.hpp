#pragma once

#include "ndframe/algebra/shared_values.hpp"
#include "stress_edges.hpp"

namespace ndframe
{

/// Which rank a face's and an edge's unknowns belong to (StressBlocks: faces, then edges), and which other ranks have
/// cells beside it and hold them, too. All ranks find the same from the cells around, without asking each other.
class StressSharing
{
public:
  StressSharing(const StressFaces& faces, const std::vector<StressEdge>& edges, const Comm& comm);

  bool owns(int block) const { return owns_[std::size_t(block)] != 0; }
  const SharedValues& values() const { return values_; } ///< of blocks
  const Comm& comm() const { return comm_; }
  /// The powerOfTwo() of the largest of all ranks' numbers. Collective.
  double unitOf(double largest) const;

private:
  void list(int block, std::vector<int> around, int owner);

  Comm comm_;
  std::vector<char> owns_;
  std::vector<SharedWith> with_; ///< per rank, while they are listed
  SharedValues values_;
};

/// The least that is not below a number: to divide by it rounds nothing. One for zero.
double powerOfTwo(double number);

} // namespace ndframe

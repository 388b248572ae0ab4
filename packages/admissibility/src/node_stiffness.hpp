#pragma once

#include <map>
#include <utility>

#include "ndframe/admissibility/contact_traction.hpp"
#include "ndframe/assembly/body_system.hpp"

namespace ndframe
{

/// A block of K, row-major, global axes; in the plane the third row and column are zero.
struct NodeBlock
{
  std::array<double, 9> K{};
  /// a . K b
  double work(const Direction& a, const Direction& b) const
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
      sum += a[i] * (K[3 * i] * b[0] + K[3 * i + 1] * b[1] + K[3 * i + 2] * b[2]);
    return sum;
  }
};

using NodeStiffness = std::map<std::pair<int, int>, NodeBlock>; ///< by nodes: row, column

/// The blocks of K between a body's interface nodes; those of nodes that share no cell are left out.
NodeStiffness interfaceStiffness(const BodyModel& body, const std::vector<ContactPatch>& patches, int bodyNumber);

} // namespace ndframe

#pragma once

#include <map>
#include <utility>

#include "ndframe/admissibility/contact_traction.hpp"
#include "ndframe/assembly/body_system.hpp"

namespace ndframe
{

/// A block of K in the plane, row-major, global axes.
struct NodeBlock
{
  std::array<double, 4> K{};
  /// a . K b
  double work(const Direction& a, const Direction& b) const
  {
    return a[0] * (K[0] * b[0] + K[1] * b[1]) + a[1] * (K[2] * b[0] + K[3] * b[1]);
  }
};

using NodeStiffness = std::map<std::pair<int, int>, NodeBlock>; ///< by nodes: row, column

/// The blocks of K between a body's interface nodes; those of nodes that share no cell are left out.
NodeStiffness interfaceStiffness(const BodyModel& body, const std::vector<ContactFacet>& facets, int bodyNumber);

} // namespace ndframe

#pragma once

#include <map>

#include "ndframe/assembly/body_system.hpp"
#include "ndframe/recovery/contact_traction.hpp"

namespace ndframe
{

/// The block of K at one node in the plane, global axes.
struct NodeBlock
{
  std::array<double, 4> K{};
  /// d . K d
  double along(const Direction& d) const
  {
    return d[0] * (K[0] * d[0] + K[1] * d[1]) + d[1] * (K[2] * d[0] + K[3] * d[1]);
  }
};

using NodeStiffness = std::map<int, NodeBlock>; ///< by node

/// The blocks of K at a body's interface nodes.
NodeStiffness interfaceStiffness(const BodyModel& body, const std::vector<ContactFacet>& facets, int bodyNumber);

} // namespace ndframe

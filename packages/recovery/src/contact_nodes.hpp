#pragma once

#include "ndframe/assembly/body_system.hpp"
#include "ndframe/recovery/contact_traction.hpp"

namespace ndframe
{

/// A body's node numbers on a contact facet in the order of ContactFacet::nodes.
inline std::array<int, 3> contactNodes(const BodyModel& body, const ContactFacet& facet, bool isDirichlet)
{
  std::array<int, 3> nodes{};
  facetNodes(body.nodes, isDirichlet ? facet.dirichlet : facet.neumann, nodes.data());
  if ((nodes[0] > nodes[1]) != (!isDirichlet && facet.reversed))
    std::swap(nodes[0], nodes[1]);
  return nodes;
}

} // namespace ndframe

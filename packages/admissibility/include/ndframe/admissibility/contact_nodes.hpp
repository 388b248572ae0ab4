#pragma once

#include "ndframe/admissibility/contact_traction.hpp"
#include "ndframe/assembly/body_system.hpp"

namespace ndframe
{

/// Vectors at a facet's nodes.
using FacetVectors = std::array<Direction, mostFacetNodes>;

/// A body's node numbers on a contact facet in the order of ContactFacet::nodes.
FacetNodes contactNodes(const BodyModel& body, const ContactFacet& facet, bool isDirichlet);

/// u1 - u2 at the nodes of a contact facet, in the order of ContactFacet::nodes. displacement: per body, numNodes *
/// dim, global axes.
FacetVectors facetOpening(const std::vector<const BodyModel*>& bodies, const ContactFacet& facet,
                          const std::vector<Vector>& displacement);

/// What of u1 - u2 counts against the deck's Gap: facetOpening, and the drawn distance where it counts.
FacetVectors closing(const std::vector<const BodyModel*>& bodies, const ContactFacet& facet,
                     const std::vector<Vector>& displacement);

} // namespace ndframe

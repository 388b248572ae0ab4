#pragma once

#include "ndframe/admissibility/contact_traction.hpp"
#include "ndframe/assembly/body_system.hpp"

namespace ndframe
{

/// Vectors at a patch's nodes.
using PatchVectors = std::array<Direction, mostFacetNodes>;

/// A body's node numbers on its side of a patch, in the order of ContactPatch::nodes.
FacetNodes contactNodes(const BodyModel& body, const PatchSide& side);

/// u1 - u2 at the nodes of a patch, in the order of ContactPatch::nodes. displacement: per body, numNodes * dim,
/// global axes.
PatchVectors patchOpening(const std::vector<const BodyModel*>& bodies, const ContactPatch& patch,
                          const std::vector<NodalField>& displacement);

/// What of u1 - u2 counts against the deck's Gap: patchOpening, and the drawn distance where it counts.
PatchVectors closing(const std::vector<const BodyModel*>& bodies, const ContactPatch& patch,
                     const std::vector<NodalField>& displacement);

} // namespace ndframe

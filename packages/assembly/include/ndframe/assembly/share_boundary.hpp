#pragma once

#include "ndframe/assembly/body_share.hpp"
#include "ndframe/mesh/boundary.hpp"

namespace ndframe
{

/// The facets of a rank's own cells that belong to one cell of the whole body only. mesh: of the share. The owner of a
/// facet's lowest vertex is told of it by all ranks that have a cell there. Collective.
std::vector<Facet> ownBoundary(const Mesh& mesh, const BodyShare& share, const Comm& comm);

} // namespace ndframe

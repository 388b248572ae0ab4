#pragma once

#include "body_overlap.hpp"
#include "ndframe/algebra/comm.hpp"

namespace ndframe
{

/// encounterOf() of bodies that ranks share: views are of this rank's cells and of their facets on the boundary of the
/// body. Ranks send those points of their facets that lie in the box of another one's cells, and get back how they
/// stand to these. Of equally deep points that with the least coordinates. Collective.
Encounter encounterOfShares(const BoundaryView& a, const BoundaryView& b, const Comm& comm);

/// Per body one mesh on every rank that has its box and nothing else. views: of this rank's cells. Collective.
std::vector<Mesh> boxesOfShares(const std::vector<BoundaryView>& views, const Comm& comm);

} // namespace ndframe

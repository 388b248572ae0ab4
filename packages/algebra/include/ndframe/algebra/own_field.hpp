#pragma once

#include "ndframe/algebra/field.hpp"

namespace ndframe
{

/// Of values at all nodes those at the nodes that this rank owns of `nodes`.
NodalField ownPart(const NodalField& all, const IndexMap& nodes);

/// Values at all nodes, on every rank, from those that each rank has at its own ones. Collective.
NodalField onEveryRank(NodalField own, const Comm& comm);

} // namespace ndframe

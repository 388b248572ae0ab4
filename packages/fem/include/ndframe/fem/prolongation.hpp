#pragma once

#include <vector>

#include "ndframe/fem/node_map.hpp"

namespace ndframe
{

/// The nodal values of a field on the uniformly refined mesh (mesh/refine.hpp): the same field, exactly.
///
/// coarse, fine: node maps of one order on a mesh and on refineUniformly of it. values: dim per coarse node; the result
/// dim per fine node.
std::vector<double> prolongate(const NodeMap& coarse, const NodeMap& fine, const std::vector<double>& values);

} // namespace ndframe

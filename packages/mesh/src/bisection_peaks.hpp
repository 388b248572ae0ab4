#pragma once

#include <array>
#include <vector>

#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// The local vertex opposite to the first refinement edge of every triangle of all meshes, one mesh after the other.
///
/// It is the longest edge. Lengths within 1e-8 of each other are equal: there edges are preferred that are a longest
/// one of both their triangles, so that marking one edge of a regular mesh does not run through the whole of it. What
/// is left is decided by position. edges: per triangle the edges opposite to its vertices, the same number for twins.
std::vector<int> firstPeaks(const std::vector<Mesh>& meshes, const std::vector<std::array<int, 3>>& edges,
                            int numEdges);

} // namespace ndframe

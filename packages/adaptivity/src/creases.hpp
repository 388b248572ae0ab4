#pragma once

#include <array>
#include <vector>

#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// The edges of a mesh of tetrahedra, by their ends, where its boundary turns by 5 degrees or more, where the sides of
/// the boundary change, and where regions meet at an angle or end at the boundary. Ascending.
std::vector<std::array<int, 2>> creasesOf(const Mesh& mesh);

} // namespace ndframe

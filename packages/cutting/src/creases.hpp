#pragma once

#include <array>
#include <map>
#include <set>

#include "side_topology.hpp"

namespace ndframe
{

/// The edges of a solid's boundary where it turns or where a named side ends, by their vertices, ascending.
std::set<std::array<int, 2>> creases(const Mesh& mesh);

/// The vertices of facets that may be moved without changing the body or where any of its named sides ends, each with
/// the straight line of creases along which it may go; zero: anywhere in its plane.
std::map<int, Vector3> looseVertices(const Mesh& mesh, const std::vector<Facet>& facets,
                                     const std::set<std::array<int, 2>>& creases);

} // namespace ndframe

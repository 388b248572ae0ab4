#pragma once

#include <utility>
#include <vector>

#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// What two sides of solids have in common.
struct CommonFacets
{
  std::vector<std::pair<int, int>> vertices; ///< at one place, first and second; ascending by the first
  /// Facets of the first side.
  std::vector<Facet> firstFacets, secondFacets; ///< of these vertices, in the same order
};

/// Vertices are one within 5e-3 of the shortest edges at them.
CommonFacets commonFacets(const Mesh& first, const Side& firstSide, const Mesh& second, const Side& secondSide);

/// The area in which two sides lie on each other, flat, whatever their facets.
double overlappingArea(const Mesh& first, const Side& firstSide, const Mesh& second, const Side& secondSide);

} // namespace ndframe

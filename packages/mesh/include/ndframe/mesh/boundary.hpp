#pragma once

#include <utility>

#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// The facets of a sound mesh that belong to one cell only, by cell and facet.
std::vector<Facet> boundaryFacets(const Mesh& mesh);

/// Pairs of cells that share a facet.
std::vector<std::pair<int, int>> neighbourCells(const Mesh& mesh);

/// Per cell its part, from 0 on in the order of their first cells: cells that facets join, one after the other, are in
/// one part. count: becomes the number of parts.
std::vector<int> connectedParts(const Mesh& mesh, int& count);

} // namespace ndframe

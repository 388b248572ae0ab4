#pragma once

#include <utility>

#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// The facets of a sound mesh that belong to one cell only, by cell and facet.
std::vector<Facet> boundaryFacets(const Mesh& mesh);

/// Pairs of cells that share a facet.
std::vector<std::pair<int, int>> neighbourCells(const Mesh& mesh);

} // namespace ndframe

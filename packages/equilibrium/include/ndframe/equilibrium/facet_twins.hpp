#pragma once

#include "ndframe/equilibrium/moment_basis.hpp"

namespace ndframe
{

/// The cells of a mesh joined across their facets. A half facet (dim + 1) * cell + facet (sorted order) is a facet as
/// one of its cells sees it. Per half facet the one of the neighbour; -1 on the boundary.
std::vector<int> facetTwins(const std::vector<SortedCell>& cells, int dim);

/// All cells of a mesh.
std::vector<SortedCell> sortedCells(const Mesh& mesh);

} // namespace ndframe

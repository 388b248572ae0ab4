#pragma once

#include <array>

#include "ndframe/fem/moment_basis.hpp"
#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// The vertices of a cell in ascending global number.
///
/// Recovery sees every cell, facet and edge through this order: two cells that share a facet then parametrise it alike,
/// and one set of reference tables serves all cells. The map F from the reference simplex may turn it inside out;
/// only |det F| occurs.
struct SortedCell
{
  std::array<int, 4> vertices{}; ///< global numbers, ascending
  std::array<int, 4> local{};    ///< where each stands in mesh.cell()
};

/// The vertices of a cell in the order of their global numbers.
SortedCell sortedCell(const Mesh& mesh, int cell);

/// Number of a facet in its cell in sorted order (it is opposite to the vertex of that number).
int sortedFacet(const Mesh& mesh, Facet facet);

/// Basis of the tractions on a facet of a body of dimension `dim`: polynomials of degree q in dim - 1 variables.
MomentBasis facetBasis(int dim, int degree);

/// Basis of the loads in a cell: polynomials of degree q - 1, for q = 1 constants on the sub-cells.
MomentBasis loadBasis(int dim, int degree);

} // namespace ndframe

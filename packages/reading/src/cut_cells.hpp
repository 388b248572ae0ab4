#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ndframe/reading/msh_file.hpp"

namespace ndframe
{

/// A cell that is no simplex. gmsh and Exodus agree on the order of its vertices; more nodes of second order follow
/// them.
struct CellShape
{
  const char* name; ///< as gmsh calls it
  std::string plural;
  int dim, vertices;
  int simplices; ///< that it is cut into
  /// Its faces (edges of a quadrangle), counterclockwise from outside, in the order of Exodus's side numbers.
  std::vector<std::vector<int>> faces;
};

/// Quadrangle, hexahedron, prism, pyramid by gmsh's name; null for others.
const CellShape* findCellShape(std::string_view name);

/// The simplices of a cell, their vertices one after the other, positively oriented as the cell is.
///
/// The cell is cut from its vertex with the smallest number: that vertex with all triangles of the faces that do not
/// contain it, which are cut from their own smallest vertex. So cells that share a face cut it alike, whatever they are
/// (Dompierre, Labbe, Vallet and Camarero 1999).
/// Limit: a cell so distorted that it is not convex may give inverted simplices, which the check of the mesh reports.
std::vector<int> simplicesOf(const CellShape& shape, const int* vertices);

/// What a user should know about cells that were cut; which: "12 hexahedra, 3 prisms".
std::string cutNote(const std::string& which, int dim);

/// Cuts the blocks of cells that are no simplices; the parts keep number and groups. Returns a sentence about the cells
/// of this dimension that were cut, empty when there were none.
std::string cutCells(MshFile& file, int dim);

} // namespace ndframe

#pragma once

#include <array>

#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// The mesh with every edge halved: a triangle becomes 4 triangles, a tetrahedron 8 tetrahedra.
///
/// Points keep their numbers, the middles of the edges follow. The children of cell c are the cells c * 2^dim + k,
/// the children of facet number f of a side the facets f * 2^(dim-1) + k of the side of the same name; lengths halve,
/// orientations and groups of cells stay. Triangles are similar to their parent. A tetrahedron's four corners are cut
/// off; the octahedron left is cut along the edge between the middles of 02 and 13 (Bey 1995), and the children's
/// vertices are ordered so that, however often this is repeated, the descendants of a tetrahedron have at most three
/// shapes. middles: takes the ends of each new point's edge.
Mesh refineUniformly(const Mesh& mesh, std::vector<std::array<int, 2>>* middles = nullptr);

/// A child's vertex: the middle of two vertices of the parent, or one of them given twice.
using ChildVertex = std::array<int, 2>;

/// 2^dim.
int numChildren(int dim);

/// The dim + 1 vertices of a child by the parent's local vertices.
const ChildVertex* childVertices(int dim, int child);

} // namespace ndframe

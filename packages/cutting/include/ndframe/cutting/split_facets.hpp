#pragma once

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "ndframe/mesh/cut_facets.hpp"

namespace ndframe
{

/// New vertices on the boundary of a tetrahedron mesh, and how facets are divided there.
struct FacetSplits
{
  using Triangle = std::array<int, 3>; ///< numbers of its vertices, old or new

  std::vector<double> points; ///< three coordinates each; numbered behind those of the mesh
  /// By the two vertices of an edge, ascending: the vertices between them, from the smaller one on.
  std::map<std::array<int, 2>, std::vector<int>> edges;
  /// By cell and local number of a facet: its triangles, turned either way. A facet of which only edges are divided
  /// need not be named.
  std::map<std::pair<int, int>, std::vector<Triangle>> facets;

  std::map<int, std::array<double, 3>> moved; ///< vertices of the mesh with another place, in the plane of their facets

  bool empty() const { return edges.empty() && facets.empty(); } ///< nothing is divided, whatever is moved
};

/// Divides facets of a tetrahedron mesh, and the cells behind them: a cell becomes the pyramids over the triangles of
/// one facet where only that one is divided, else those of all its facets around its centre, which is a new vertex.
///
/// The body stays what it is with its groups of cells and sides. New vertices of an edge inside a flat part of the
/// boundary may lie beside it, in the plane, as long as no cell turns over (else CannotCut). Other cells keep their
/// vertices. Points and cells keep their numbers, new ones follow. A facet inside the body is divided alike by both of
/// its cells, in the order of the numbers of its edges' vertices.
DerivedMesh splitFacets(const Mesh& mesh, const FacetSplits& splits);

} // namespace ndframe

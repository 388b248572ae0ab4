#pragma once

#include <array>
#include <vector>

#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// The nodes of a Lagrange space of order 1 or 2 on a mesh of straight simplices.
///
/// Nodes 0..numPoints-1 are the mesh's points; order 2 adds one node per edge, in the middle of it.
/// Local order in a cell: vertices, then edges in the order of SimplexEdges<dim>, Exodus's: 01, 12, 20 for triangles,
/// 01, 12, 20, 03, 13, 23 for tetrahedra.
struct NodeMap
{
  int dim = 0;                ///< of space; 0: an empty map
  int order = 0;              ///< 1 or 2
  int nodesPerCell = 0;       ///< 3, 6 (dim 2) or 4, 10 (dim 3) for order 1, 2
  int nodesPerFacet = 0;      ///< 2, 3 (dim 2) or 3, 6 (dim 3) for order 1, 2
  std::vector<int> cellNodes; ///< nodesPerCell * numCells
  std::vector<double> points; ///< dim * numVertices
  /// Of each node on an edge, after the vertices, the ends of the edge; empty for order 1.
  std::vector<std::array<int, 2>> edges{};

  int numVertices() const { return dim == 0 ? 0 : int(points.size()) / dim; } ///< nodes that are points of the mesh
  int numNodes() const { return numVertices() + int(edges.size()); }          ///< vertices, and edges for order 2
  int numCells() const { return nodesPerCell == 0 ? 0 : int(cellNodes.size()) / nodesPerCell; } ///< of the mesh
  /// The nodesPerCell nodes of a cell, in the local order.
  const int* cell(int c) const { return cellNodes.data() + std::size_t(c) * std::size_t(nodesPerCell); }
  /// The ends of the edge that a node is the middle of; a vertex is both of its ends.
  std::array<int, 2> ends(int node) const
  {
    return node < numVertices() ? std::array<int, 2>{node, node} : edges[std::size_t(node - numVertices())];
  }
  /// The coordinates of a node, zero beyond dim.
  std::array<double, 3> point(int node) const
  {
    const auto [a, b] = ends(node);
    std::array<double, 3> x{};
    for (int k = 0; k < dim; ++k)
      x[std::size_t(k)] = a == b ? coordinate(a, k) : 0.5 * (coordinate(a, k) + coordinate(b, k));
    return x;
  }
  double coordinate(int vertex, int k) const { return points[std::size_t(vertex) * std::size_t(dim) + std::size_t(k)]; }
};

/// order: 1 or 2.
NodeMap makeNodeMap(const Mesh& mesh, int order);

/// ends() of all nodes of an order 2 map. Empty for order 1.
std::vector<std::array<int, 2>> edgeEnds(const NodeMap& map);
/// Coordinates of all nodes, dim for each.
std::vector<double> nodePoints(const NodeMap& map);

/// Local numbers of a facet's nodes: its vertices in increasing local number, then (order 2) its edges in the order
/// 01, 12, 20 of these vertices. nodesPerFacet entries.
const int* facetLocalNodes(int dim, int order, int localFacet);

/// Node numbers of a facet in the order of facetLocalNodes.
void facetNodes(const NodeMap& map, Facet facet, int* nodes);

/// All nodes of a side, ascending, without repetition.
std::vector<int> sideNodes(const NodeMap& map, const Side& side);

} // namespace ndframe

#pragma once

#include <array>
#include <vector>

#include "ndframe/equilibrium/moment_basis.hpp"
#include "ndframe/mesh/vertex_cells.hpp"

namespace ndframe
{

/// A cell of a star.
struct StarCell
{
  int cell; ///< in the mesh
  SortedCell sorted;
  int apex; ///< sorted number of the star's vertex; the facet of this number is the rim
};

/// A facet that contains the star's vertex.
struct Spoke
{
  std::array<int, 2> cell{-1, -1};  ///< numbers in Star::cells; the second is -1 on the boundary
  std::array<int, 2> facet{-1, -1}; ///< its sorted number in each cell

  bool onBoundary() const { return cell[1] < 0; }
};

/// All cells with a vertex in common.
struct Star
{
  int vertex = 0;
  std::vector<StarCell> cells;
  std::vector<Spoke> spokes;

  /// Sorted number of the star's vertex on a facet of its cell.
  static int apexOnFacet(int apex, int facet) { return apex < facet ? apex : apex - 1; }
};

Star makeStar(const Mesh& mesh, const VertexCells& around, int vertex);

/// The cells of a star joined through interior spokes.
struct SpanningTree
{
  std::vector<int> order;  ///< cells, each after the one that it hangs on; shorter than the star if it falls to pieces
  std::vector<int> parent; ///< per cell the spoke to the cell it hangs on; -1 for the first
  std::vector<char> used;  ///< per spoke: it belongs to the tree
};

SpanningTree spanningTree(const Star& star);

/// Vertices in classes without neighbours (no cell in common); within a class ascending.
std::vector<std::vector<int>> colourVertices(const Mesh& mesh, const VertexCells& around);

} // namespace ndframe

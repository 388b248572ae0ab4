#include "ndframe/equilibrium/facet_twins.hpp"

#include <algorithm>

#include "ndframe/mesh/vertex_tuples.hpp"

namespace ndframe
{

std::vector<int> facetTwins(const std::vector<SortedCell>& cells, int dim)
{
  std::vector<int> vertices;
  vertices.reserve(cells.size() * std::size_t(dim + 1) * std::size_t(dim));
  int numVertices = 0;
  for (const SortedCell& cell : cells) {
    numVertices = std::max(numVertices, cell.vertices[std::size_t(dim)] + 1);
    for (int facet = 0; facet <= dim; ++facet)
      for (int v = 0; v <= dim; ++v)
        if (v != facet)
          vertices.push_back(cell.vertices[std::size_t(v)]);
  }
  const VertexTuples halves(std::move(vertices), dim, numVertices);
  std::vector<int> twin(std::size_t(halves.size()), -1);
  for (int place = 0, end = 0; place < halves.size(); place = end) {
    end = halves.groupEnd(place);
    for (; place + 1 < end; ++place) {
      twin[std::size_t(halves.at(place))] = halves.at(place + 1);
      twin[std::size_t(halves.at(place + 1))] = halves.at(place);
    }
  }
  return twin;
}

std::vector<SortedCell> sortedCells(const Mesh& mesh)
{
  std::vector<SortedCell> cells;
  cells.reserve(std::size_t(mesh.numCells()));
  for (int cell = 0; cell < mesh.numCells(); ++cell)
    cells.push_back(sortedCell(mesh, cell));
  return cells;
}

} // namespace ndframe

#include "ndframe/mesh/boundary.hpp"

#include <algorithm>

#include "ndframe/base/joined_numbers.hpp"
#include "ndframe/mesh/vertex_tuples.hpp"

namespace ndframe
{

std::vector<Facet> boundaryFacets(const Mesh& mesh)
{
  const VertexTuples facets = allFacets(mesh, mesh.numPoints());
  std::vector<int> numbers;
  for (int place = 0, end = 0; place < facets.size(); place = end) {
    end = facets.groupEnd(place);
    if (end - place == 1)
      numbers.push_back(facets.at(place));
  }
  std::sort(numbers.begin(), numbers.end());
  std::vector<Facet> boundary;
  for (const int number : numbers)
    boundary.push_back({number / (mesh.dim + 1), number % (mesh.dim + 1)});
  return boundary;
}

std::vector<std::pair<int, int>> neighbourCells(const Mesh& mesh)
{
  const VertexTuples facets = allFacets(mesh, mesh.numPoints());
  std::vector<std::pair<int, int>> pairs;
  for (int place = 0, end = 0; place < facets.size(); place = end) {
    end = facets.groupEnd(place);
    if (end - place == 2)
      pairs.emplace_back(facets.at(place) / (mesh.dim + 1), facets.at(place + 1) / (mesh.dim + 1));
  }
  return pairs;
}

std::vector<int> connectedParts(const Mesh& mesh, int& count)
{
  JoinedNumbers cells(mesh.numCells());
  for (const auto& [cell, neighbour] : neighbourCells(mesh))
    cells.join(cell, neighbour);
  return std::move(cells).numbered(count);
}

} // namespace ndframe

#include "ndframe/equilibrium/facet_twins.hpp"

#include <algorithm>

namespace ndframe
{
namespace
{

struct HalfFacet
{
  std::array<int, 3> vertices{-1, -1, -1};
  int number;
};

} // namespace

std::vector<int> facetTwins(const std::vector<SortedCell>& cells, int dim)
{
  std::vector<HalfFacet> halves;
  halves.reserve(cells.size() * std::size_t(dim + 1));
  for (const SortedCell& cell : cells)
    for (int facet = 0; facet <= dim; ++facet) {
      HalfFacet half{{-1, -1, -1}, int(halves.size())};
      for (int v = 0; v < dim; ++v)
        half.vertices[std::size_t(v)] = cell.vertices[std::size_t(v < facet ? v : v + 1)];
      halves.push_back(half);
    }
  std::sort(halves.begin(), halves.end(), [](const auto& a, const auto& b) { return a.vertices < b.vertices; });
  std::vector<int> twin(halves.size(), -1);
  for (std::size_t i = 1; i < halves.size(); ++i)
    if (halves[i].vertices == halves[i - 1].vertices) {
      twin[std::size_t(halves[i].number)] = halves[i - 1].number;
      twin[std::size_t(halves[i - 1].number)] = halves[i].number;
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

#include "ndframe/equilibrium/facet_twins.hpp"

#include <algorithm>
#include <numeric>

namespace ndframe
{
namespace
{

struct HalfFacet
{
  std::array<int, 2> others{-1, -1}; ///< its vertices but the lowest
  int number = 0;
};

} // namespace

/// Half facets are sorted by their lowest vertices first, which takes no comparisons.
std::vector<int> facetTwins(const std::vector<SortedCell>& cells, int dim)
{
  const auto vertexOf = [](const SortedCell& cell, int facet, int v) {
    return cell.vertices[std::size_t(v < facet ? v : v + 1)];
  };
  int vertices = 0;
  for (const SortedCell& cell : cells)
    vertices = std::max(vertices, cell.vertices[std::size_t(dim)] + 1);
  std::vector<int> next(std::size_t(vertices) + 1, 0);
  for (const SortedCell& cell : cells)
    for (int facet = 0; facet <= dim; ++facet)
      ++next[std::size_t(vertexOf(cell, facet, 0)) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  const std::vector<int> first = next;
  std::vector<HalfFacet> halves(cells.size() * std::size_t(dim + 1));
  int number = 0;
  for (const SortedCell& cell : cells)
    for (int facet = 0; facet <= dim; ++facet, ++number) {
      HalfFacet& half = halves[std::size_t(next[std::size_t(vertexOf(cell, facet, 0))]++)];
      half.number = number;
      for (int v = 1; v < dim; ++v)
        half.others[std::size_t(v) - 1] = vertexOf(cell, facet, v);
    }
  std::vector<int> twin(halves.size(), -1);
  for (std::size_t v = 0; v + 1 < first.size(); ++v) {
    const auto begin = halves.begin() + first[v], end = halves.begin() + first[v + 1];
    std::sort(begin, end, [](const auto& a, const auto& b) { return a.others < b.others; });
    for (auto half = begin; half != end && half + 1 != end; ++half)
      if (half->others == (half + 1)->others) {
        twin[std::size_t(half->number)] = (half + 1)->number;
        twin[std::size_t((half + 1)->number)] = half->number;
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

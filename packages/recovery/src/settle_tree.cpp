#include "settle_tree.hpp"

#include <algorithm>
#include <array>

namespace ndframe
{

CellTree::CellTree(const Mesh& mesh)
{
  for (int cell = 0; cell < mesh.numCells(); ++cell)
    cells_.push_back(sortedCell(mesh, cell));
  join(mesh.dim);
  std::vector<char> seen(cells_.size(), 0);
  for (int cell = 0; cell < mesh.numCells(); ++cell) {
    if (seen[std::size_t(cell)])
      continue;
    const Part part = treeFrom(cell, mesh.dim + 1);
    for (const int member : part.cells)
      seen[std::size_t(member)] = 1;
    const int root = *std::max_element(part.cells.begin(), part.cells.end(),
                                       [&](int a, int b) { return cellMeasure(mesh, a) < cellMeasure(mesh, b); });
    parts_.push_back(treeFrom(root, mesh.dim + 1));
  }
}

void CellTree::join(int dim)
{
  struct HalfFacet
  {
    std::array<int, 3> vertices;
    int half;
  };
  std::vector<HalfFacet> halves;
  for (std::size_t cell = 0; cell < cells_.size(); ++cell)
    for (int facet = 0; facet <= dim; ++facet) {
      HalfFacet half{{-1, -1, -1}, int(cell) * (dim + 1) + facet};
      for (int v = 0, next = 0; v <= dim; ++v)
        if (v != facet)
          half.vertices[std::size_t(next++)] = cells_[cell].vertices[std::size_t(v)];
      halves.push_back(half);
    }
  std::sort(halves.begin(), halves.end(), [](const auto& a, const auto& b) { return a.vertices < b.vertices; });
  twin_.assign(halves.size(), -1);
  for (std::size_t i = 1; i < halves.size(); ++i)
    if (halves[i].vertices == halves[i - 1].vertices) {
      twin_[std::size_t(halves[i].half)] = halves[i - 1].half;
      twin_[std::size_t(halves[i - 1].half)] = halves[i].half;
    }
}

CellTree::Part CellTree::treeFrom(int root, int facets) const
{
  Part part{{root}, {-1}};
  std::vector<char> seen(cells_.size(), 0);
  seen[std::size_t(root)] = 1;
  for (std::size_t at = 0; at < part.cells.size(); ++at)
    for (int half = part.cells[at] * facets; half < (part.cells[at] + 1) * facets; ++half) {
      if (twin(half) < 0 || seen[std::size_t(twin(half) / facets)])
        continue;
      seen[std::size_t(twin(half) / facets)] = 1;
      part.cells.push_back(twin(half) / facets);
      part.towardsRoot.push_back(twin(half));
    }
  return part;
}

} // namespace ndframe

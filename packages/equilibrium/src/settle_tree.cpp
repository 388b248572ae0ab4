#include "settle_tree.hpp"

#include <algorithm>

#include "ndframe/equilibrium/facet_twins.hpp"

namespace ndframe
{

CellTree::CellTree(const Mesh& mesh, std::vector<char> isIn)
    : cells_(sortedCells(mesh)), twin_(facetTwins(cells_, mesh.dim)), isIn_(std::move(isIn))
{
  if (isIn_.empty())
    isIn_.assign(cells_.size(), 1);
  std::vector<char> seen(cells_.size(), 0);
  for (int cell = 0; cell < mesh.numCells(); ++cell) {
    if (seen[std::size_t(cell)] || !isIn_[std::size_t(cell)])
      continue;
    const Part part = treeFrom(cell);
    for (const int member : part.cells)
      seen[std::size_t(member)] = 1;
    const int root = *std::max_element(part.cells.begin(), part.cells.end(),
                                       [&](int a, int b) { return cellMeasure(mesh, a) < cellMeasure(mesh, b); });
    parts_.push_back(treeFrom(root));
  }
}

CellTree::Part CellTree::treeFrom(int root) const
{
  Part part{{root}, {-1}};
  const int facets = int(twin_.size() / cells_.size());
  std::vector<char> seen(cells_.size(), 0);
  seen[std::size_t(root)] = 1;
  for (std::size_t at = 0; at < part.cells.size(); ++at)
    for (int half = part.cells[at] * facets; half < (part.cells[at] + 1) * facets; ++half) {
      const int next = twin(half) < 0 ? -1 : twin(half) / facets;
      if (next < 0 || seen[std::size_t(next)] || !isIn_[std::size_t(next)])
        continue;
      seen[std::size_t(next)] = 1;
      part.cells.push_back(next);
      part.towardsRoot.push_back(twin(half));
    }
  return part;
}

} // namespace ndframe

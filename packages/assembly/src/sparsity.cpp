#include "sparsity.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace ndframe
{
namespace
{

/// Cells around each node, as a compressed list.
struct NodeCells
{
  std::vector<int> first, cells;
};

NodeCells cellsAroundNodes(const NodeMap& nodes)
{
  NodeCells around{std::vector<int>(std::size_t(nodes.numNodes()) + 1, 0), std::vector<int>(nodes.cellNodes.size())};
  for (const int node : nodes.cellNodes)
    ++around.first[std::size_t(node) + 1];
  std::partial_sum(around.first.begin(), around.first.end(), around.first.begin());
  std::vector<int> next(around.first.begin(), around.first.end() - 1);
  for (std::size_t i = 0; i < nodes.cellNodes.size(); ++i)
    around.cells[std::size_t(next[std::size_t(nodes.cellNodes[i])]++)] = int(i / std::size_t(nodes.nodesPerCell));
  return around;
}

} // namespace

BlockMatrix makeSparsity(const NodeMap& nodes, const std::vector<int>& ownedNodes)
{
  const NodeCells around = cellsAroundNodes(nodes);
  std::vector<int> cols, lastRow(std::size_t(nodes.numNodes()), -1);
  std::vector<std::int64_t> rowPtr{0};
  rowPtr.reserve(ownedNodes.size() + 1);
  cols.reserve(ownedNodes.size() * (nodes.dim == 2 ? 12 : 30));
  for (const int row : ownedNodes) {
    const auto begin = std::ptrdiff_t(cols.size());
    for (int i = around.first[std::size_t(row)]; i < around.first[std::size_t(row) + 1]; ++i) {
      const int* cell = nodes.cell(around.cells[std::size_t(i)]);
      for (int a = 0; a < nodes.nodesPerCell; ++a)
        if (std::exchange(lastRow[std::size_t(cell[a])], row) != row)
          cols.push_back(cell[a]);
    }
    std::sort(cols.begin() + begin, cols.end());
    rowPtr.push_back(std::int64_t(cols.size()));
  }
  cols.shrink_to_fit();
  return withOwnColumns(nodes.dim, nodes.numNodes(), ownedNodes, std::move(rowPtr), std::move(cols), {});
}

} // namespace ndframe

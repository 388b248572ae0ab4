#include "ndframe/mesh/vertex_cells.hpp"

namespace ndframe
{

VertexCells::VertexCells(const Mesh& mesh) : start_(std::size_t(mesh.numPoints()) + 1, 0), cells_(mesh.cells.size())
{
  for (const int vertex : mesh.cells)
    ++start_[std::size_t(vertex) + 1];
  for (std::size_t v = 1; v < start_.size(); ++v)
    start_[v] += start_[v - 1];
  std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
  for (std::size_t i = 0; i < mesh.cells.size(); ++i)
    cells_[next[std::size_t(mesh.cells[i])]++] = int(i) / (mesh.dim + 1);
}

} // namespace ndframe

#pragma once

#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// The cells around every vertex of a mesh, ascending.
class VertexCells
{
public:
  explicit VertexCells(const Mesh& mesh); ///< the mesh need not outlive this
  const int* begin(int vertex) const { return cells_.data() + start_[std::size_t(vertex)]; }   ///< its first cell
  const int* end(int vertex) const { return cells_.data() + start_[std::size_t(vertex) + 1]; } ///< past its last

private:
  std::vector<std::size_t> start_;
  std::vector<int> cells_;
};

} // namespace ndframe

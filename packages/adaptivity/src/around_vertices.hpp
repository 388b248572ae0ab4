#pragma once

#include "ndframe/algebra/comm.hpp"
#include "ndframe/mesh/vertex_cells.hpp"

namespace ndframe
{

/// At every vertex the mean of what the cells around it have.
template <class OfCell>
Vector meanAroundVertices(const Mesh& mesh, const OfCell& ofCell)
{
  const VertexCells cells(mesh);
  Vector means;
  for (int v = 0; v < mesh.numPoints(); ++v) {
    double sum = 0.0;
    for (const int* c = cells.begin(v); c != cells.end(v); ++c)
      sum += ofCell(*c);
    means.push_back(sum / double(cells.end(v) - cells.begin(v)));
  }
  return means;
}

} // namespace ndframe

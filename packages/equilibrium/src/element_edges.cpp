#include "ndframe/equilibrium/element_edges.hpp"

#include <algorithm>

#include "ndframe/equilibrium/facet_twins.hpp"
#include "ndframe/equilibrium/self_touching.hpp"

namespace ndframe
{
namespace
{

void checkFansAreWhole(const EdgeMap& edges, const BodyModel& body)
{
  const Mesh& mesh = body.mesh;
  std::vector<int> cellsAt(std::size_t(mesh.numPoints()), 0);
  for (const int vertex : mesh.cells)
    ++cellsAt[std::size_t(vertex)];
  for (int vertex = 0; vertex < mesh.numPoints(); ++vertex)
    if (int(fanAround(edges, vertex).cells.size()) != cellsAt[std::size_t(vertex)])
      throw SelfTouching(body, vertex);
}

} // namespace

EdgeMap edgeMap(const BodyModel& body)
{
  const Mesh& mesh = body.mesh;
  NDFRAME_ASSERT(mesh.dim == 2, "half edges are those of triangles");
  EdgeMap edges{sortedCells(mesh), {}, {}};
  edges.twin = facetTwins(edges.cells, 2);
  edges.start.assign(std::size_t(mesh.numPoints()), -1);
  for (int half = 0; half < 3 * mesh.numCells(); ++half)
    for (int corner = 0; corner < 3; ++corner) {
      int& start = edges.start[std::size_t(edges.cells[std::size_t(half / 3)].vertices[std::size_t(corner)])];
      if (corner != half % 3 && (start < 0 || (edges.onBoundary(half) && !edges.onBoundary(start))))
        start = half;
    }
  checkFansAreWhole(edges, body);
  return edges;
}

EdgeFan fanAround(const EdgeMap& edges, int vertex)
{
  EdgeFan fan;
  const int first = edges.start[std::size_t(vertex)];
  int half = first;
  do {
    const int cell = half / 3;
    const auto& v = edges.cells[std::size_t(cell)].vertices;
    const int corner = int(std::find(v.begin(), v.begin() + 3, vertex) - v.begin());
    const int out = 3 * cell + 3 - corner - half % 3;
    fan.cells.push_back({cell, corner, half, out});
    half = edges.twin[std::size_t(out)];
  } while (half >= 0 && half != first);
  fan.closed = half == first;
  return fan;
}

} // namespace ndframe

#include "element_edges.hpp"

#include <algorithm>
#include <tuple>

#include <fmt/format.h>

namespace ndframe
{
namespace
{

std::vector<int> findTwins(const std::vector<SortedCell>& cells)
{
  using Edge = std::tuple<int, int, int>; // vertices, half edge
  std::vector<Edge> all;
  all.reserve(3 * cells.size());
  for (int half = 0; half < 3 * int(cells.size()); ++half) {
    const auto& v = cells[std::size_t(half / 3)].vertices;
    const int facet = half % 3;
    all.emplace_back(v[facet == 0 ? 1 : 0], v[facet == 2 ? 1 : 2], half);
  }
  std::sort(all.begin(), all.end());
  std::vector<int> twin(all.size(), -1);
  for (std::size_t e = 1; e < all.size(); ++e) {
    const auto& [a, b, half] = all[e - 1];
    const auto& [c, d, other] = all[e];
    if (a == c && b == d) {
      twin[std::size_t(half)] = other;
      twin[std::size_t(other)] = half;
    }
  }
  return twin;
}

void checkFansAreWhole(const EdgeMap& edges, const BodyModel& body)
{
  const Mesh& mesh = body.mesh;
  std::vector<int> cellsAt(std::size_t(mesh.numPoints()), 0);
  for (const int vertex : mesh.cells)
    ++cellsAt[std::size_t(vertex)];
  for (int vertex = 0; vertex < mesh.numPoints(); ++vertex)
    if (int(fanAround(edges, vertex).cells.size()) != cellsAt[std::size_t(vertex)])
      throw InputError(
          fmt::format("Bodies/{}: the mesh touches itself at the point {} only; join its cells there through "
                      "an edge, or give the two parts points of their own",
                      body.name, pointText(mesh.point(vertex), mesh.dim)));
}

} // namespace

EdgeMap edgeMap(const BodyModel& body)
{
  const Mesh& mesh = body.mesh;
  NDFRAME_ASSERT(mesh.dim == 2, "half edges are those of triangles");
  EdgeMap edges;
  for (int c = 0; c < mesh.numCells(); ++c)
    edges.cells.push_back(sortedCell(mesh, c));
  edges.twin = findTwins(edges.cells);
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

Fan fanAround(const EdgeMap& edges, int vertex)
{
  Fan fan;
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

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "ndframe/interface/obstacle.hpp"

namespace ndframe
{
namespace
{

/// The layer's thickness, relative to the size of what lies on it.
constexpr double thickness = 0.04;
/// Where its directions differ it is no thicker than this, relative to the shortest edge: it must not fold.
constexpr double ofEdge = 0.25;

/// A vertex of the side and where it leads.
struct Column
{
  int front = 0, back = 0; ///< vertices of the layer
  Direction inward{};      ///< away from the side
};

std::map<int, Column> columnsOf(const Mesh& first, const ObstacleSurface& surface)
{
  std::map<int, Column> columns;
  for (const Facet facet : surface.facets) {
    Direction normal{};
    const double measure = facetNormal(first, facet, normal.data());
    if (surface.normal)
      normal = *surface.normal;
    int vertices[3];
    facetVertices(first, facet, vertices);
    for (const int vertex : vertices)
      for (std::size_t k = 0; k < 3; ++k)
        columns[vertex].inward[k] += measure * normal[k];
  }
  for (auto& [vertex, column] : columns) {
    const double length = std::sqrt(dotProduct(column.inward, column.inward));
    for (double& component : column.inward)
      component /= length;
  }
  return columns;
}

double shortestEdge(const Mesh& mesh, const std::vector<Facet>& facets)
{
  double shortest = std::numeric_limits<double>::max();
  for (const Facet facet : facets) {
    int v[3];
    facetVertices(mesh, facet, v);
    for (int i = 0; i < 3; ++i) {
      const double *a = mesh.point(v[i]), *b = mesh.point(v[(i + 1) % 3]);
      shortest = std::min(shortest, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
    }
  }
  return shortest;
}

double depthOf(const Mesh& mesh, const ObstacleSurface& surface, const std::map<int, Column>& columns)
{
  Direction low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  bool isFlat = true;
  for (const auto& [vertex, column] : columns) {
    isFlat = isFlat && dotProduct(column.inward, columns.begin()->second.inward) > 1.0 - 1e-9;
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], mesh.point(vertex)[k]);
      high[k] = std::max(high[k], mesh.point(vertex)[k]);
    }
  }
  const double depth = thickness * std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  return isFlat ? depth : std::min(depth, ofEdge * shortestEdge(mesh, surface.facets));
}

/// A tetrahedron with positive measure; the first three vertices stay together.
void addCell(Mesh& mesh, std::array<int, 4> v)
{
  const auto first = mesh.cells.insert(mesh.cells.end(), v.begin(), v.end());
  if (cellMeasure(mesh, mesh.numCells() - 1) < 0.0)
    std::swap(first[0], first[1]);
}

} // namespace

void addLayer(Mesh& mesh, const std::string& name, const Mesh& first, const ObstacleSurface& surface)
{
  auto columns = columnsOf(first, surface);
  const double depth = depthOf(first, surface, columns);
  mesh.dim = 3;
  for (auto& [vertex, column] : columns) {
    column.front = mesh.numPoints();
    column.back = column.front + 1;
    for (const double by : {0.0, depth})
      for (std::size_t k = 0; k < 3; ++k)
        mesh.points.push_back(first.point(vertex)[k] + by * column.inward[k]);
  }
  Side side{name, {}};
  for (const Facet facet : surface.facets) {
    int vertices[3];
    facetVertices(first, facet, vertices);
    std::sort(vertices,
              vertices + 3); // all prisms cut their walls from the smaller one's front to the larger one's back
    const Column &a = columns.at(vertices[0]), &b = columns.at(vertices[1]), &c = columns.at(vertices[2]);
    side.facets.push_back({mesh.numCells(), 3});
    addCell(mesh, {a.front, b.front, c.front, c.back});
    addCell(mesh, {a.front, b.front, b.back, c.back});
    addCell(mesh, {a.front, a.back, b.back, c.back});
  }
  mesh.sides.push_back(std::move(side));
}

} // namespace ndframe

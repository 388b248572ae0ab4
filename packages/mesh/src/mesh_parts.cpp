#include "ndframe/mesh/mesh_parts.hpp"

#include <algorithm>

namespace ndframe
{

MeshParts::MeshParts(const Mesh& mesh)
    : mesh_(mesh), pointOf_(std::size_t(mesh.numPoints()), -1), cellOf_(std::size_t(mesh.numCells()), -1)
{}

Mesh MeshParts::of(const std::vector<int>& cells, const std::vector<int>& points)
{
  Mesh part{mesh_.dim, {}, {}, {}, mesh_.notes, {mesh_.groups.names, {}}};
  for (const int point : points) {
    pointOf_[std::size_t(point)] = part.numPoints();
    part.points.insert(part.points.end(), mesh_.point(point), mesh_.point(point) + mesh_.dim);
  }
  for (const int cell : cells) {
    cellOf_[std::size_t(cell)] = part.numCells();
    for (int v = 0; v <= mesh_.dim; ++v)
      part.cells.push_back(pointOf_[std::size_t(mesh_.cell(cell)[v])]);
    if (!mesh_.groups.kind.empty())
      part.groups.kind.push_back(mesh_.groups.kind[std::size_t(cell)]);
  }
  for (const Side& side : mesh_.sides) {
    part.sides.push_back({side.name, {}});
    for (const Facet facet : side.facets)
      if (const int cell = cellOf_[std::size_t(facet.cell)]; cell >= 0)
        part.sides.back().facets.push_back({cell, facet.local});
  }
  for (const int point : points)
    pointOf_[std::size_t(point)] = -1;
  for (const int cell : cells)
    cellOf_[std::size_t(cell)] = -1;
  return part;
}

std::vector<int> pointsOfCells(const Mesh& mesh, const std::vector<int>& cells)
{
  std::vector<int> points;
  points.reserve(cells.size() * std::size_t(mesh.dim + 1));
  for (const int cell : cells)
    points.insert(points.end(), mesh.cell(cell), mesh.cell(cell) + mesh.dim + 1);
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

} // namespace ndframe

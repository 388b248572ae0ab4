#include "surface_fans.hpp"

#include <algorithm>
#include <numeric>

#include "ndframe/mesh/vertex_tuples.hpp"

namespace ndframe
{
namespace
{

/// Unites the corners of triangles that edges inside fans hold together. Returns one corner for each end of such an
/// edge.
std::vector<int> uniteCorners(const TriangleSurface& surface, double cornerAngle, UnitedSets& sets)
{
  const auto& triangles = surface.triangles;
  std::vector<int> edges; // edge i of a triangle goes from its vertex i to the next one
  for (const auto& triangle : triangles)
    for (std::size_t i = 0; i < 3; ++i)
      edges.insert(edges.end(), {triangle[i], triangle[(i + 1) % 3]});
  const auto cornerAt = [&](int triangle, int vertex) {
    const auto& own = triangles[std::size_t(triangle)];
    return 3 * triangle + int(std::find(own.begin(), own.end(), vertex) - own.begin());
  };
  const VertexTuples sorted(edges, 2, int(surface.points.size()));
  std::vector<int> inside;
  for (int at = 0, next = 0; at < sorted.size(); at = next) {
    next = sorted.groupEnd(at);
    if (next != at + 2)
      continue;
    const int a = sorted.at(at) / 3, b = sorted.at(at + 1) / 3;
    const Vector3 &m = surface.normals[std::size_t(a)], &n = surface.normals[std::size_t(b)];
    if (std::atan2(norm(cross(m, n)), dot(m, n)) > cornerAngle)
      continue;
    for (int end = 0; end < 2; ++end) {
      const int vertex = edges[2 * std::size_t(sorted.at(at)) + std::size_t(end)];
      sets.unite(cornerAt(a, vertex), cornerAt(b, vertex));
      inside.push_back(cornerAt(a, vertex));
    }
  }
  return inside;
}

} // namespace

UnitedSets::UnitedSets(std::size_t numbers) : parent_(numbers)
{
  std::iota(parent_.begin(), parent_.end(), 0);
}

int UnitedSets::of(int number)
{
  while (parent_[std::size_t(number)] != number)
    number = parent_[std::size_t(number)] = parent_[std::size_t(parent_[std::size_t(number)])];
  return number;
}

SurfaceFans makeFans(const TriangleSurface& surface, double cornerAngle)
{
  const std::size_t corners = 3 * surface.triangles.size();
  UnitedSets sets(corners);
  const std::vector<int> inside = uniteCorners(surface, cornerAngle, sets);
  SurfaceFans result;
  std::vector<int> number(corners, -1);
  for (int corner = 0; corner < int(corners); ++corner) {
    int& fan = number[std::size_t(sets.of(corner))];
    if (fan < 0) {
      fan = int(result.fans.size());
      result.fans.emplace_back();
    }
    Fan& own = result.fans[std::size_t(fan)];
    own.vertex = surface.triangles[std::size_t(corner / 3)][std::size_t(corner % 3)];
    own.triangles.push_back(corner / 3);
    result.ofTriangle.push_back(fan);
  }
  for (const int corner : inside)
    ++result.fans[std::size_t(result.ofTriangle[std::size_t(corner)])].edges;
  return result;
}

} // namespace ndframe

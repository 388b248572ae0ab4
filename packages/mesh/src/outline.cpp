#include "ndframe/mesh/outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "ndframe/mesh/vertex_tuples.hpp"

namespace ndframe
{
namespace
{

constexpr double straight = 1e-7;   ///< angles below are round-off
constexpr double samePlace = 1e-11; ///< of the coordinates
constexpr int mostVertices = 3;     ///< of a facet

using Vector3 = std::array<double, 3>;

/// The directions in which a set of facets changes around a vertex: normals of its facets, and normals of its rim in
/// the facets' planes. They leave a line of no change if and only if they do not span the space.
struct Changes
{
  std::array<Vector3, 3> squares{}; ///< sum of the directions' squares (d d^T)

  void add(const Vector3& d)
  {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        squares[i][j] += d[i] * d[j];
  }

  /// The sum of the squared volumes that dim of the directions span (Cauchy and Binet).
  double volumes(int dim) const
  {
    const auto& m = squares;
    const double plane = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    if (dim == 2)
      return plane;
    return m[2][2] * plane - m[0][2] * (m[2][0] * m[1][1] - m[1][0] * m[2][1]) -
           m[1][2] * (m[0][0] * m[2][1] - m[0][1] * m[2][0]);
  }
};

/// A facet without one of its vertices: an end of an edge, or an edge of a triangle.
struct Ridge
{
  int facets = 0;
  Vector3 conormal{}; ///< of one of them
};

std::array<int, mostVertices> sortedVertices(const Mesh& mesh, Facet facet)
{
  std::array<int, mostVertices> vertices{-1, -1, -1};
  facetVertices(mesh, facet, vertices.data());
  for (std::size_t end = std::size_t(mesh.dim) - 1; end > 0; --end)
    for (std::size_t i = 0; i < end; ++i)
      if (vertices[i + 1] < vertices[i])
        std::swap(vertices[i], vertices[i + 1]);
  return vertices;
}

/// The unit vector in a facet's plane, normal to the ridge that leaves out the vertex at `left`.
Vector3 conormal(const Mesh& mesh, const std::array<int, mostVertices>& vertices, int left)
{
  const double* tip = mesh.point(vertices[std::size_t(left)]);
  const double* foot = mesh.point(vertices[left == 0 ? 1 : 0]);
  Vector3 d{}, along{};
  for (std::size_t k = 0; k < std::size_t(mesh.dim); ++k)
    d[k] = tip[k] - foot[k];
  const auto dot = [](const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  if (mesh.dim == 3) {
    const double* end = mesh.point(vertices[left == 2 ? 1 : 2]);
    for (std::size_t k = 0; k < 3; ++k)
      along[k] = end[k] - foot[k];
    const double part = dot(d, along) / dot(along, along);
    for (std::size_t k = 0; k < 3; ++k)
      d[k] -= part * along[k];
  }
  const double length = std::sqrt(dot(d, d));
  for (double& x : d)
    x /= length;
  return d;
}

/// Points in an order that a mesh has no part in.
void sortPoints(std::vector<double>& points, int dim)
{
  constexpr Vector3 direction{0.6180339887, 0.7548776662, 0.5698402910}; // no scene is aligned with it
  std::vector<std::pair<double, Vector3>> places;
  for (std::size_t i = 0; i < points.size(); i += std::size_t(dim)) {
    Vector3 p{};
    double along = 0.0;
    for (std::size_t k = 0; k < std::size_t(dim); ++k) {
      p[k] = points[i + k];
      along += direction[k] * p[k];
    }
    places.emplace_back(along, p);
  }
  std::sort(places.begin(), places.end());
  points.clear();
  for (const auto& [along, p] : places)
    points.insert(points.end(), p.begin(), p.begin() + dim);
}

Outline sideOutline(const Mesh& mesh, const std::vector<Facet>& facets)
{
  Outline outline;
  std::map<int, Changes> around;
  std::map<std::array<int, mostVertices>, Ridge> ridges;
  for (const Facet facet : facets) {
    Vector3 normal{};
    outline.measure += facetNormal(mesh, facet, normal.data());
    const auto vertices = sortedVertices(mesh, facet);
    for (int v = 0; v < mesh.dim; ++v) {
      around[vertices[std::size_t(v)]].add(normal);
      auto ridge = vertices;
      ridge[std::size_t(v)] = -1;
      std::sort(ridge.begin(), ridge.end());
      Ridge& met = ridges[ridge];
      ++met.facets;
      met.conormal = conormal(mesh, vertices, v);
    }
  }
  for (const auto& [vertices, ridge] : ridges)
    for (const int v : vertices)
      if (v >= 0 && ridge.facets == 1)
        around[v].add(ridge.conormal);
  for (const auto& [v, changes] : around) {
    const double* p = mesh.point(v);
    for (int k = 0; k < mesh.dim; ++k)
      outline.size = std::max(outline.size, std::abs(p[k]));
    if (changes.volumes(mesh.dim) > straight * straight)
      outline.corners.insert(outline.corners.end(), p, p + mesh.dim);
  }
  sortPoints(outline.corners, mesh.dim);
  return outline;
}

/// The facets on which cells of a kind border on others, by kind.
std::vector<std::vector<Facet>> bordersOfKinds(const Mesh& mesh)
{
  std::vector<std::vector<Facet>> borders(mesh.groups.names.size());
  const int facets = mesh.dim + 1;
  const VertexTuples all = allFacets(mesh, mesh.numPoints());
  for (int place = 0, end = 0; place < all.size(); place = end) {
    end = all.groupEnd(place);
    const int one = all.at(place), other = all.at(end - 1);
    if (!mesh.groups.sameKind(one / facets, other / facets))
      for (const int facet : {one, other})
        borders[std::size_t(mesh.groups.kind[std::size_t(facet / facets)])].push_back({facet / facets, facet % facets});
  }
  return borders;
}

/// A part of the body: its size instead of that of its border, and the corners of its border on other parts.
void addKinds(const Mesh& mesh, MeshOutline& outline)
{
  if (mesh.groups.kind.empty())
    return;
  std::vector<double> measures(mesh.groups.names.size(), 0.0);
  for (int c = 0; c < mesh.numCells(); ++c)
    measures[std::size_t(mesh.groups.kind[std::size_t(c)])] += cellMeasure(mesh, c);
  const auto borders = bordersOfKinds(mesh);
  for (std::size_t k = 0; k < borders.size(); ++k) {
    std::string name = "cells of";
    for (const std::string& group : mesh.groups.names[k])
      name += "\n" + group;
    outline.sides.emplace_back(name, sideOutline(mesh, borders[k]));
    outline.sides.back().second.measure = measures[k];
  }
}

bool isSame(const Outline& a, const Outline& b)
{
  if (a.corners.size() != b.corners.size())
    return false;
  const double round = samePlace * std::max(a.size, b.size);
  for (std::size_t i = 0; i < a.corners.size(); ++i)
    if (std::abs(a.corners[i] - b.corners[i]) > round)
      return false;
  return std::abs(a.measure - b.measure) <= samePlace * std::max(a.measure, b.measure);
}

} // namespace

MeshOutline outlineOf(const Mesh& mesh)
{
  MeshOutline outline;
  for (int c = 0; c < mesh.numCells(); ++c)
    outline.measure += cellMeasure(mesh, c);
  for (const Side& side : mesh.sides)
    outline.sides.emplace_back(side.name, sideOutline(mesh, side.facets));
  addKinds(mesh, outline);
  std::sort(outline.sides.begin(), outline.sides.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  return outline;
}

bool sameOutline(const MeshOutline& a, const MeshOutline& b)
{
  if (a.sides.size() != b.sides.size() || std::abs(a.measure - b.measure) > samePlace * std::max(a.measure, b.measure))
    return false;
  for (std::size_t i = 0; i < a.sides.size(); ++i)
    if (a.sides[i].first != b.sides[i].first || !isSame(a.sides[i].second, b.sides[i].second))
      return false;
  return true;
}

} // namespace ndframe

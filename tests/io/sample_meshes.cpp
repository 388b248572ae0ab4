#include "io/sample_meshes.hpp"

#include <array>
#include <map>
#include <set>

namespace ndframe::test
{
namespace
{

Mesh rectangle(double bottom)
{
  Mesh mesh;
  mesh.dim = 2;
  for (const double y : {bottom, bottom + 1.0})
    for (const double x : {0.0, 1.0, 2.0})
      mesh.points.insert(mesh.points.end(), {x, y});
  mesh.cells = {0, 1, 4, 4, 3, 0, 1, 2, 5, 1, 5, 4};
  return mesh;
}

/// Six tetrahedra around the diagonal of the cube (Kuhn), positively oriented.
Mesh cube(double bottom)
{
  Mesh mesh;
  mesh.dim = 3;
  for (const double z : {bottom, bottom + 1.0})
    for (const double y : {0.0, 1.0})
      for (const double x : {0.0, 1.0})
        mesh.points.insert(mesh.points.end(), {x, y, z});
  mesh.cells = {0, 1, 3, 7, 0, 2, 6, 7, 0, 4, 5, 7, 0, 5, 1, 7, 0, 3, 2, 7, 0, 6, 4, 7};
  return mesh;
}

std::set<int> verticesOf(const Mesh& mesh, Facet facet)
{
  std::array<int, 3> vertices{};
  facetVertices(mesh, facet, vertices.data());
  return {vertices.begin(), vertices.begin() + mesh.dim};
}

} // namespace

Side sideWhere(const Mesh& mesh, const std::string& name, const std::function<bool(const double* point)>& contains)
{
  std::map<std::set<int>, std::vector<Facet>> cellsAt;
  for (int cell = 0; cell < mesh.numCells(); ++cell)
    for (int local = 0; local <= mesh.dim; ++local)
      cellsAt[verticesOf(mesh, {cell, local})].push_back({cell, local});
  Side side{name, {}};
  for (const auto& [vertices, facets] : cellsAt) {
    bool inside = facets.size() == 1;
    for (const int vertex : vertices)
      inside = inside && contains(mesh.point(vertex));
    if (inside)
      side.facets.push_back(facets.front());
  }
  return side;
}

Mesh sampleMesh(int dim, double bottom)
{
  Mesh mesh = dim == 2 ? rectangle(bottom) : cube(bottom);
  mesh.sides = {sideWhere(mesh, "low", [&](const double* x) { return x[dim - 1] == bottom; }),
                sideWhere(mesh, "high", [&](const double* x) { return x[dim - 1] == bottom + 1.0; }),
                sideWhere(mesh, "all", [](const double*) { return true; }),
                sideWhere(mesh, "none", [](const double*) { return false; })};
  return mesh;
}

} // namespace ndframe::test

#include "creases.hpp"

#include <map>

#include "flat_pairs.hpp"
#include "ndframe/mesh/boundary.hpp"

namespace ndframe
{
namespace
{

/// Normals and directions differ by less: round-off.
constexpr double sameNormal = 1e-9, sameLine = 1e-9;

/// A part of the boundary: its normal, and which named sides it belongs to.
struct Part
{
  Vector3 normal{};
  std::vector<std::size_t> sides;

  bool isLike(const Part& other) const
  {
    return sides == other.sides && norm(minus(normal, other.normal)) <= sameNormal;
  }
};

} // namespace

std::set<std::array<int, 2>> creases(const Mesh& mesh)
{
  std::map<std::pair<int, int>, Part> parts;
  for (const Facet facet : boundaryFacets(mesh))
    facetNormal(mesh, facet, parts[{facet.cell, facet.local}].normal.data());
  for (std::size_t s = 0; s < mesh.sides.size(); ++s)
    for (const Facet facet : mesh.sides[s].facets)
      parts[{facet.cell, facet.local}].sides.push_back(s);
  std::map<std::array<int, 2>, const Part*> ofEdge;
  std::set<std::array<int, 2>> edges;
  for (const auto& [facet, part] : parts) {
    int v[3];
    facetVertices(mesh, {facet.first, facet.second}, v);
    for (int k = 0; k < 3; ++k) {
      const int a = std::min(v[k], v[(k + 1) % 3]), b = std::max(v[k], v[(k + 1) % 3]);
      const auto [known, isNew] = ofEdge.insert({{a, b}, &part});
      if (!isNew && !known->second->isLike(part))
        edges.insert({a, b});
    }
  }
  return edges;
}

std::map<int, Vector3> looseVertices(const Mesh& mesh, const std::vector<Facet>& facets,
                                     const std::set<std::array<int, 2>>& creases)
{
  std::map<int, Vector3> ways;
  std::map<int, std::vector<int>> ends;
  for (const auto& [a, b] : creases) {
    ends[a].push_back(b);
    ends[b].push_back(a);
  }
  const auto at = [&mesh](int vertex) {
    const double* x = mesh.point(vertex);
    return Vector3{x[0], x[1], x[2]};
  };
  for (const Facet facet : facets) {
    int vertices[3];
    facetVertices(mesh, facet, vertices);
    for (const int vertex : vertices) {
      const auto found = ends.find(vertex);
      if (found == ends.end())
        ways[vertex] = {};
      if (found == ends.end() || found->second.size() != 2)
        continue;
      const Vector3 one = minus(at(found->second[0]), at(vertex)), other = minus(at(found->second[1]), at(vertex));
      if (norm(crossProduct(one, other)) <= sameLine * norm(one) * norm(other))
        ways[vertex] = one;
    }
  }
  return ways;
}

} // namespace ndframe

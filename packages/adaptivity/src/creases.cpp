#include "creases.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "ndframe/mesh/vertex_tuples.hpp"

namespace ndframe
{
namespace
{

/// Facets are in the same surface if nothing but an edge is between them.
struct Surface
{
  std::vector<int> sides; ///< numbers; -1: between regions
  std::array<double, 3> normal;
};

bool goesOn(const Surface& a, const Surface& b)
{
  constexpr double straight = 0.9962; // cos 5 degrees
  const double cosine = a.normal[0] * b.normal[0] + a.normal[1] * b.normal[1] + a.normal[2] * b.normal[2];
  return a.sides == b.sides && std::abs(cosine) > straight;
}

/// Per facet number 4 * cell + local.
std::map<int, std::vector<int>> sidesOfFacets(const Mesh& mesh)
{
  std::map<int, std::vector<int>> sides;
  for (std::size_t s = 0; s < mesh.sides.size(); ++s)
    for (const Facet facet : mesh.sides[s].facets)
      sides[4 * facet.cell + facet.local].push_back(int(s));
  return sides;
}

} // namespace

std::vector<std::array<int, 2>> creasesOf(const Mesh& mesh)
{
  const auto sides = sidesOfFacets(mesh);
  const VertexTuples facets = allFacets(mesh, mesh.numPoints());
  std::map<std::array<int, 2>, std::vector<Surface>> surfaces; // around every edge
  for (int place = 0, end = 0; place < facets.size(); place = end) {
    end = facets.groupEnd(place);
    const int number = facets.at(place);
    const bool isInside = end - place == 2;
    if (isInside && mesh.groups.sameKind(number / 4, facets.at(place + 1) / 4))
      continue;
    Surface surface{isInside ? std::vector<int>{-1} : std::vector<int>{}, {}};
    if (const auto found = sides.find(number); found != sides.end())
      surface.sides = found->second;
    facetNormal(mesh, {number / 4, number % 4}, surface.normal.data());
    int v[3];
    facetVertices(mesh, {number / 4, number % 4}, v);
    for (const auto& [a, b] : {std::minmax(v[0], v[1]), std::minmax(v[0], v[2]), std::minmax(v[1], v[2])})
      surfaces[{a, b}].push_back(surface);
  }
  std::vector<std::array<int, 2>> creases;
  for (const auto& [ends, around] : surfaces)
    if (around.size() != 2 || !goesOn(around[0], around[1]))
      creases.push_back(ends);
  return creases;
}

} // namespace ndframe

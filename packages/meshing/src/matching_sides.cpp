#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "ndframe/mesh/vertex_tuples.hpp"
#include "ndframe/meshing/remesh.hpp"

namespace ndframe
{
namespace
{

/// Mesh, cell, local number.
using Place = std::tuple<int, int, int>;

Place placeOf(int mesh, Facet facet)
{
  return {mesh, facet.cell, facet.local};
}

/// The facets of a side of a mesh, in order.
std::vector<Place> placesOf(int mesh, const Side& side)
{
  std::vector<Place> places;
  for (const Facet facet : side.facets)
    places.push_back(placeOf(mesh, facet));
  std::sort(places.begin(), places.end());
  return places;
}

/// The other sides of the facets, in order; none when one of them has none.
std::vector<Place> twinsOf(const std::vector<Place>& facets, const std::map<Place, Place>& twins)
{
  std::vector<Place> others;
  for (const Place& facet : facets) {
    const auto found = twins.find(facet);
    if (found == twins.end())
      return {};
    others.push_back(found->second);
  }
  std::sort(others.begin(), others.end());
  return others;
}

/// Of a facet's middle from another's.
constexpr double samePlace = 0.1;

struct Middle
{
  double x, y, length;
};

Middle middleOf(const Mesh& mesh, Facet facet)
{
  int ends[2];
  facetVertices(mesh, facet, ends);
  const double *a = mesh.point(ends[0]), *b = mesh.point(ends[1]);
  return {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), std::hypot(b[0] - a[0], b[1] - a[1])};
}

const std::vector<Facet>& facetsOf(const std::vector<Mesh>& meshes, int mesh, const std::string& name)
{
  const Side* side = meshes[std::size_t(mesh)].findSide(name);
  NDFRAME_ASSERT(side, "matching sides exist");
  return side->facets;
}

} // namespace

std::vector<FacetTwin> twinsOf(const std::vector<Mesh>& meshes, const std::vector<MatchingSides>& matching)
{
  std::vector<FacetTwin> twins;
  for (const MatchingSides& sides : matching)
    for (const Facet facet : facetsOf(meshes, sides.first, sides.firstSide)) {
      const Middle here = middleOf(meshes[std::size_t(sides.first)], facet);
      for (const Facet other : facetsOf(meshes, sides.second, sides.secondSide)) {
        const Middle there = middleOf(meshes[std::size_t(sides.second)], other);
        if (std::hypot(there.x - here.x, there.y - here.y) <= samePlace * here.length)
          twins.push_back({sides.first, facet, sides.second, other});
      }
    }
  return twins;
}

std::vector<FacetTwin> commonFacets(const std::vector<Mesh>& meshes)
{
  using Triangle = std::array<std::array<double, 3>, 3>;
  std::map<Triangle, std::pair<int, Facet>> met;
  std::vector<FacetTwin> twins;
  for (std::size_t b = 0; b < meshes.size(); ++b) {
    const VertexTuples facets = allFacets(meshes[b], meshes[b].numPoints());
    for (int place = 0, end = 0; place < facets.size(); place = end) {
      end = facets.groupEnd(place);
      if (end - place > 1)
        continue;
      const Facet facet{facets.at(place) / 4, facets.at(place) % 4};
      int vertices[3];
      facetVertices(meshes[b], facet, vertices);
      Triangle triangle;
      for (std::size_t v = 0; v < 3; ++v)
        std::copy_n(meshes[b].point(vertices[v]), 3, triangle[v].begin());
      std::sort(triangle.begin(), triangle.end());
      const auto [other, isNew] = met.emplace(triangle, std::pair(int(b), facet));
      if (!isNew && other->second.first != int(b))
        twins.push_back({other->second.first, other->second.second, int(b), facet});
    }
  }
  return twins;
}

std::vector<MatchingSides> matchingSides(const std::vector<Mesh>& meshes, const std::vector<FacetTwin>& twins)
{
  std::map<Place, Place> twinOf;
  for (const FacetTwin& twin : twins) {
    const std::pair<Place, Place> ends =
        std::minmax({placeOf(twin.first, twin.firstFacet), placeOf(twin.second, twin.secondFacet)});
    twinOf.emplace(ends.first, ends.second);
  }
  std::map<std::vector<Place>, std::pair<int, std::string>> sideOf; // one name for the same facets is enough
  for (std::size_t b = 0; b < meshes.size(); ++b)
    for (const Side& side : meshes[b].sides)
      sideOf.emplace(placesOf(int(b), side), std::pair(int(b), side.name));
  std::vector<MatchingSides> matching;
  for (const auto& [facets, first] : sideOf)
    if (const auto second = sideOf.find(twinsOf(facets, twinOf)); second != sideOf.end())
      matching.push_back({first.first, first.second, second->second.first, second->second.second});
  return matching;
}

} // namespace ndframe

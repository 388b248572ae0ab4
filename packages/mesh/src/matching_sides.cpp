#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "ndframe/mesh/remesh.hpp"

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

} // namespace

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

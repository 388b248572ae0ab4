#include "ndframe/cutting/common_facets.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "flat_pairs.hpp"
#include "ndframe/mesh/nearest_point.hpp"

namespace ndframe
{
namespace
{

constexpr double onePlace = 5e-3;

/// The vertices of a side.
struct SideVertices
{
  const Mesh& mesh;
  std::vector<int> vertices;
};

std::vector<int> verticesOf(const Mesh& mesh, const Side& side)
{
  std::set<int> vertices;
  for (const Facet facet : side.facets) {
    int ofFacet[3];
    facetVertices(mesh, facet, ofFacet);
    vertices.insert(ofFacet, ofFacet + 3);
  }
  return {vertices.begin(), vertices.end()};
}

/// Per vertex of one side the nearest one of the other side.
std::map<int, int> nearestOf(const SideVertices& from, const SideVertices& to)
{
  const NearestPoint tree(to.mesh, to.vertices);
  std::map<int, int> nearest;
  for (const int vertex : from.vertices)
    nearest[vertex] = to.vertices[tree.find(from.mesh.point(vertex)).index];
  return nearest;
}

} // namespace

CommonFacets commonFacets(const Mesh& first, const Side& firstSide, const Mesh& second, const Side& secondSide)
{
  const SideTopology ours(first, firstSide.facets), theirs(second, secondSide.facets);
  const SideVertices mine{first, verticesOf(first, firstSide)}, others{second, verticesOf(second, secondSide)};
  const auto forward = nearestOf(mine, others), back = nearestOf(others, mine);
  CommonFacets common;
  std::map<int, int> partner; // of the second side's
  for (const auto& [v, w] : forward)
    if (back.at(w) == v &&
        norm(minus(ours.point(v), theirs.point(w))) <= onePlace * std::min(ours.sizeAt(v), theirs.sizeAt(w)))
    {
      common.vertices.emplace_back(v, w);
      partner[w] = v;
    }
  std::map<std::array<int, 3>, int> place;
  for (int f = 0; f < ours.numFacets(); ++f) {
    auto key = ours.vertices(f);
    std::sort(key.begin(), key.end());
    place[key] = f;
  }
  std::map<int, Facet> pairs; // by place in the first side
  for (int g = 0; g < theirs.numFacets(); ++g) {
    std::array<int, 3> key{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto found = partner.find(theirs.vertices(g)[k]);
      key[k] = found == partner.end() ? -1 : found->second;
    }
    std::sort(key.begin(), key.end());
    if (const auto found = place.find(key); found != place.end())
      pairs[found->second] = theirs.facet(g);
  }
  for (const auto& [f, facet] : pairs) {
    common.firstFacets.push_back(ours.facet(f));
    common.secondFacets.push_back(facet);
  }
  return common;
}

double overlappingArea(const Mesh& first, const Side& firstSide, const Mesh& second, const Side& secondSide)
{
  double area = 0.0;
  for (const auto& pair :
       overlappingFacets(SideTopology(first, firstSide.facets), SideTopology(second, secondSide.facets)))
    area += pair.area;
  return area;
}

} // namespace ndframe

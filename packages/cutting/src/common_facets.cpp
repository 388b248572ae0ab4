#include "ndframe/cutting/common_facets.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <nanoflann.hpp>

#include "flat_pairs.hpp"

namespace ndframe
{
namespace
{

constexpr double onePlace = 5e-3;

/// The vertices of a side as nanoflann wants them.
struct VertexCloud
{
  const Mesh& mesh;
  std::vector<int> vertices;

  std::size_t kdtree_get_point_count() const { return vertices.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t k) const { return mesh.point(vertices[i])[k]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const
  {
    return false;
  }
};

using Tree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, VertexCloud>, VertexCloud, 3, std::size_t>;

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
std::map<int, int> nearestOf(const VertexCloud& from, const VertexCloud& to)
{
  const Tree tree(3, to, nanoflann::KDTreeSingleIndexAdaptorParams(10));
  std::map<int, int> nearest;
  for (const int vertex : from.vertices) {
    std::size_t index = 0;
    double squared = 0.0;
    tree.knnSearch(from.mesh.point(vertex), 1, &index, &squared);
    nearest[vertex] = to.vertices[index];
  }
  return nearest;
}

} // namespace

CommonFacets commonFacets(const Mesh& first, const Side& firstSide, const Mesh& second, const Side& secondSide)
{
  const SideTopology ours(first, firstSide.facets), theirs(second, secondSide.facets);
  const VertexCloud mine{first, verticesOf(first, firstSide)}, others{second, verticesOf(second, secondSide)};
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

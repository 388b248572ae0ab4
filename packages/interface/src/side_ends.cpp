#include <cmath>
#include <optional>

#include "ndframe/cutting/solid_sides.hpp"
#include "ndframe/interface/insertion.hpp"
#include "ndframe/mesh/loose_vertices.hpp"

namespace ndframe
{
namespace
{

/// A vertex is moved to where the other side ends when it is nearer than this part of its shorter facet; else the facet
/// is cut.
constexpr double near = 0.35;
/// Places on a facet nearer than this to an end are there.
constexpr double alreadyThere = 1e-7;

/// Where edges of the other side end, as places on edges of this one: {edge, place}.
std::vector<std::pair<int, double>> endsOn(const SideMap& map, bool onFirst)
{
  std::vector<std::pair<int, double>> ends;
  for (const SideSegment& segment : map.segments()) {
    if (map.first().edges()[std::size_t(segment.firstEdge)].turns ||
        map.second().edges()[std::size_t(segment.secondEdge)].turns)
      continue;
    for (const std::size_t k : {0u, 1u}) {
      const double mine = onFirst ? segment.first[k] : segment.second[k],
                   theirs = onFirst ? segment.second[k] : segment.first[k];
      if ((theirs == 0.0 || theirs == 1.0) && mine != 0.0 && mine != 1.0)
        ends.emplace_back(onFirst ? segment.firstEdge : segment.secondEdge, mine);
    }
  }
  return ends;
}

/// The facet that a place on an edge lies in, and where there.
std::optional<std::pair<Facet, double>> facetAt(const SidePolygon& polygon, const Mesh& mesh, const Side& side,
                                                int edge, double place)
{
  for (const Facet facet : side.facets) {
    const Stretch on = polygon.locate(mesh, facet);
    const double there = (place - on.from) / (on.to - on.from);
    if (on.edge == edge && there >= 0.0 && there <= 1.0)
      return std::pair(facet, there);
  }
  return std::nullopt;
}

/// True when the mesh was changed.
bool makeVertex(const SidePolygon& polygon, Mesh& mesh, const std::string& name, int edge, double place)
{
  const auto found = facetAt(polygon, mesh, *mesh.findSide(name), edge, place);
  if (!found)
    return false;
  const auto [facet, there] = *found;
  if (std::min(there, 1.0 - there) < alreadyThere)
    return false;
  int ends[3];
  double normal[3];
  facetVertices(mesh, facet, ends);
  const Direction at = polygon.edges()[std::size_t(edge)].at(place);
  const int vertex = ends[there < 0.5 ? 0 : 1];
  LooseVertices loose(mesh, name);
  const double apart = std::min(there, 1.0 - there) * facetNormal(mesh, facet, normal);
  if (apart > near * loose.shortestFacetAt(vertex) || !loose.move(vertex, at.data()))
    mesh = cutFacets(mesh, {{{facet.cell, facet.local}, {there}}}).mesh;
  return true;
}

} // namespace

std::vector<char> addSideEnds(std::vector<Mesh>& meshes, const std::vector<FacingSides>& interfaces,
                              const std::vector<char>& isRigid, bool willBeRefined)
{
  std::vector<char> changed(meshes.size(), 0);
  for (const FacingSides& sides : interfaces) {
    const auto first = std::size_t(sides.firstBody), second = std::size_t(sides.secondBody);
    if (!sides.map) {
      if (!sides.isCut || first == second)
        continue;
      const auto moved = moveToRims(meshes[first], sides.firstSide, meshes[second], sides.secondSide);
      const bool firstIsCut =
                     willBeRefined && cutAtRims(meshes[first], sides.firstSide, meshes[second], sides.secondSide),
                 secondIsCut =
                     willBeRefined && cutAtRims(meshes[second], sides.secondSide, meshes[first], sides.firstSide);
      changed[first] |= char(moved[0] || firstIsCut);
      changed[second] |= char(moved[1] || secondIsCut);
      continue;
    }
    for (const bool onFirst : {true, false}) {
      const auto body = std::size_t(onFirst ? sides.firstBody : sides.secondBody);
      if (isRigid[body])
        continue;
      for (const auto& [edge, place] : endsOn(*sides.map, onFirst))
        if (makeVertex(onFirst ? sides.map->first() : sides.map->second(), meshes[body],
                       onFirst ? sides.firstSide : sides.secondSide, edge, place))
          changed[body] = 1;
    }
  }
  return changed;
}

} // namespace ndframe

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "ndframe/interface/normal_field.hpp"
#include "side_facets.hpp"

namespace ndframe
{
namespace
{

/// The nodes of a piece's two facets, in the order of the first one's facetNodes.
struct FacingNodes
{
  std::array<int, 3> first{}, second{};
};

FacingNodes nodesOf(const FacingPiece& piece, const NodeMap& first, const NodeMap& second)
{
  FacingNodes nodes;
  facetNodes(first, piece.first, nodes.first.data());
  facetNodes(second, piece.second, nodes.second.data());
  if ((piece.onFirst[0] < piece.onFirst[1]) != (piece.onSecond[0] < piece.onSecond[1]))
    std::swap(nodes.second[0], nodes.second[1]);
  return nodes;
}

void addPoints(std::vector<double>& points, const NodeMap& map, int node)
{
  const auto x = map.point(node);
  points.insert(points.end(), x.begin(), x.begin() + map.dim);
}

/// Quadratic bodies know curves exactly as far as the sides do; linear ones are polygons.
SideMap::Shape shapeFor(const SideMap& map, int order)
{
  return order == 2 ? map.outlines() : SideMap::Shape::Polygons;
}

/// Numbers the pairs of nodes that face each other; a node with two partners is two interface nodes.
void addFacingNodes(InterfaceMesh& interface, const SideMap& map, const std::vector<FacingPiece>& pieces,
                    const NodeMap& first, const NodeMap& second)
{
  std::vector<std::pair<int, int>> ofFacets;
  for (const FacingPiece& piece : pieces) {
    const FacingNodes nodes = nodesOf(piece, first, second);
    for (std::size_t i = 0; i < std::size_t(first.nodesPerFacet); ++i)
      ofFacets.emplace_back(nodes.first[i], nodes.second[i]);
  }
  std::map<std::pair<int, int>, int> number;
  for (const auto& pair : ofFacets)
    number[pair] = 0;
  int next = 0;
  for (auto& [nodes, place] : number) {
    place = next++;
    interface.sides[0].nodes.push_back(nodes.first);
    interface.sides[1].nodes.push_back(nodes.second);
    addPoints(interface.points, first, nodes.first);
    addPoints(interface.partners, second, nodes.second);
  }
  for (const auto& pair : ofFacets)
    interface.facets.push_back(number.at(pair));
  interface.apart.resize(number.size());
  const auto shape = shapeFor(map, first.order);
  const int* node = interface.facets.data();
  for (const FacingPiece& piece : pieces) {
    const bool forward = piece.onFirst[0] < piece.onFirst[1];
    const std::array<double, 3> places{piece.at[forward ? 0 : 1], piece.at[forward ? 1 : 0],
                                       0.5 * (piece.at[0] + piece.at[1])};
    for (std::size_t i = 0; i < std::size_t(first.nodesPerFacet); ++i)
      interface.apart[std::size_t(*node++)] = map.apart(map.segments()[piece.segment], places[i], shape);
  }
}

/// n at the vertices of a piece's first facet; zeros where the facet keeps its own.
VertexNormals normalsOf(const SideMap& map, const FacingPiece& piece)
{
  const SideSegment& segment = map.segments()[piece.segment];
  if (!map.first().edges()[std::size_t(segment.firstEdge)].turns)
    return {};
  VertexNormals ends{map.normal(segment, piece.at[0]), map.normal(segment, piece.at[1])};
  if (piece.onFirst[0] > piece.onFirst[1])
    std::swap(ends[0], ends[1]);
  return ends;
}

void refuseOverlap(const InterfaceSettings& settings, const SideMap& map, SideMap::Shape shape)
{
  const auto [deepest, where] = map.deepestOverlap(shape);
  if (deepest < 0.0)
    throw InputError(settings.place.mistake(
        "Gap From Geometry", fmt::format("the bodies overlap at the start: by {:.3g} at {}; move one of the "
                                         "meshes, or ignore the drawn distance (Gap From Geometry = No).",
                                         -deepest, pointText(where.data(), 2))));
}

} // namespace

InterfaceMesh pairFacing(const InterfaceSettings& settings, const BodyModel& dirichlet, const BodyModel& neumann,
                         std::shared_ptr<const SideMap> map, const std::string& more)
{
  const Side& first = findSide(settings, ContactRole::Dirichlet, dirichlet);
  const Side& second = findSide(settings, ContactRole::Neumann, neumann);
  const auto pieces = facingPieces(*map, dirichlet.mesh, first.facets, neumann.mesh, second.facets);
  if (pieces.empty())
    throw InputError(settings.place.mistake(
        "", fmt::format("no part of {}/{} faces {}/{}: along n_c, the outward normal of the first, "
                        "no part of the second faces back; name the sides that face each other.",
                        dirichlet.name, first.name, neumann.name, second.name)));
  InterfaceMesh interface = emptyInterface(settings.name, dirichlet);
  addFacingNodes(interface, *map, pieces, dirichlet.nodes, neumann.nodes);
  std::vector<Facet> facets;
  for (const FacingPiece& piece : pieces) {
    facets.push_back(piece.first);
    interface.sides[1].facets.push_back(piece.second);
    interface.endNormals.push_back(normalsOf(*map, piece));
  }
  addNormals(interface, dirichlet.mesh, facets);
  const auto turns = [](const auto& ends) { return dotProduct(ends[0], ends[0]) > 0.0; };
  if (std::none_of(interface.endNormals.begin(), interface.endNormals.end(), turns))
    interface.endNormals.clear();
  else
    setNodeNormals(interface);
  evaluateGap(settings, interface, more);
  interface.map = std::move(map);
  interface.isCut = true;
  return interface;
}

void addDrawnGap(const InterfaceSettings& settings, InterfaceMesh& interface)
{
  const DrawnGap wanted = settings.drawnGap;
  if (!interface.map || wanted == DrawnGap::No || (wanted == DrawnGap::Automatic && interface.map->touches()))
    return;
  refuseOverlap(settings, *interface.map, shapeFor(*interface.map, interface.order));
  for (std::size_t i = 0; i < interface.gap.size(); ++i) {
    interface.drawnGap.push_back(dotProduct(interface.normals[i], interface.apart[i]));
    interface.gap[i] += interface.drawnGap.back();
  }
}

} // namespace ndframe

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "ndframe/base/expression.hpp"
#include "ndframe/cutting/common_facets.hpp"
#include "ndframe/interface/normal_field.hpp"
#include "ndframe/mesh/nearest_point.hpp"
#include "side_facets.hpp"

namespace ndframe
{
namespace
{

/// Two nodes face each other when their distance lies along the normal, up to this cosine.
constexpr double facing = 0.999;

/// The nodes of one side.
struct SideNodes
{
  const NodeMap& map;
  std::vector<int> nodes;
};

double shortestFacet(const Mesh& mesh, const Side& side)
{
  double shortest = std::numeric_limits<double>::max(), normal[3];
  for (const Facet facet : side.facets)
    shortest = std::min(shortest, facetNormal(mesh, facet, normal));
  return mesh.dim == 2 ? shortest : std::sqrt(shortest);
}

/// Two sides: for each node of `from` the nearest one of `to` and how far it is.
struct Comparison
{
  const SideNodes& from;
  const SideNodes& to;
  std::vector<std::size_t> nearest;
  std::vector<double> distance;

  std::size_t worst() const
  {
    return std::size_t(std::max_element(distance.begin(), distance.end()) - distance.begin());
  }
  double largestDistance() const { return distance[worst()]; }
  std::string worstPosition() const { return pointText(from.map.point(from.nodes[worst()]).data(), from.map.dim); }
};

Comparison compare(const SideNodes& from, const SideNodes& to)
{
  const NearestPoint tree(to.map, to.nodes);
  Comparison comparison{from, to, {}, {}};
  for (const int node : from.nodes) {
    const auto [index, squared] = tree.find(from.map.point(node).data());
    comparison.nearest.push_back(index);
    comparison.distance.push_back(std::sqrt(squared));
  }
  return comparison;
}

/// Sides whose nodes face each other along the normal, but not at the same place, overlap or are apart.
void refuseOffset(const InterfaceSettings& settings, const Comparison& sides, const std::vector<Direction>& normals,
                  const std::string& names)
{
  const std::size_t worst = sides.worst();
  const auto x = sides.from.map.point(sides.from.nodes[worst]);
  const auto y = sides.to.map.point(sides.to.nodes[sides.nearest[worst]]);
  const double distance = sides.largestDistance();
  double along = 0.0;
  for (std::size_t k = 0; k < std::size_t(sides.from.map.dim); ++k)
    along += (y[k] - x[k]) * normals[worst][k];
  if (along < -facing * distance)
    throw InputError(
        settings.place.mistake("", fmt::format("the bodies overlap at the start: by {:.3g} at {} ({}); move "
                                               "one of the meshes.",
                                               distance, sides.worstPosition(), names)));
  if (along > facing * distance)
    throw InputError(settings.place.mistake(
        "Gap",
        fmt::format("the sides are apart by {:.3g} at {} ({}); let the meshes touch and give the opening as Gap.",
                    distance, sides.worstPosition(), names)));
}

void refuseMissing(const InterfaceSettings& settings, const Comparison& sides, double tolerance,
                   const std::string& names)
{
  const auto missing =
      std::count_if(sides.distance.begin(), sides.distance.end(), [&](double d) { return d > tolerance; });
  if (missing > 0)
    throw InputError(settings.place.mistake(
        "", fmt::format(
                "the sides do not match ({}): {} of {} nodes have no partner, the largest distance is {:.3g} at {}.",
                names, missing, sides.distance.size(), sides.largestDistance(), sides.worstPosition())));
}

/// Finds the Neumann body's facet for each interface facet by its vertices; false when one is missing.
bool matchFacets(InterfaceMesh& interface, const BodyModel& neumann, const Side& side)
{
  std::map<std::vector<int>, Facet> byNodes;
  std::vector<int> nodes(std::size_t(neumann.nodes.nodesPerFacet));
  for (const Facet facet : side.facets) {
    facetNodes(neumann.nodes, facet, nodes.data());
    auto key = nodes;
    std::sort(key.begin(), key.end());
    byNodes.emplace(std::move(key), facet);
  }
  for (int f = 0; f < interface.numFacets(); ++f) {
    for (std::size_t a = 0; a < nodes.size(); ++a)
      nodes[a] = interface.sides[1].nodes[std::size_t(interface.nodesOf(f)[a])];
    std::sort(nodes.begin(), nodes.end());
    const auto found = byNodes.find(nodes);
    if (found == byNodes.end())
      return false;
    interface.sides[1].facets.push_back(found->second);
  }
  return byNodes.size() == interface.measures.size();
}

Diagnostic otherFacets(const InterfaceSettings& settings, const std::string& names)
{
  return settings.place.mistake("", fmt::format("the sides do not match ({}): they share their nodes but are cut into "
                                                "different facets.",
                                                names));
}

void refuseSameSide(const InterfaceSettings& settings, const InterfaceMesh& interface, const BodyModel& dirichlet,
                    const BodyModel& neumann)
{
  for (int f = 0; f < interface.numFacets(); ++f) {
    Direction n1{}, n2{};
    facetNormal(dirichlet.mesh, interface.sides[0].facets[std::size_t(f)], n1.data());
    facetNormal(neumann.mesh, interface.sides[1].facets[std::size_t(f)], n2.data());
    if (dotProduct(n1, n2) > 0.0)
      throw InputError(settings.place.mistake(
          "",
          fmt::format("the bodies overlap at the start: \"{}\" and \"{}\" lie on the same side of the interface at {}; "
                      "name the sides that face each other.",
                      dirichlet.name, neumann.name, pointText(interface.point(*interface.nodesOf(f)), interface.dim))));
  }
}

/// A rigid body may have the normal.
void setNormal(InterfaceMesh& interface, const ObstacleSurface* surface)
{
  for (auto* normals : {&interface.normals, &interface.facetNormals})
    if (surface != nullptr && surface->normal)
      std::fill(normals->begin(), normals->end(), *surface->normal);
}

std::string sideText(const BodyModel& dirichlet, const Side& first, const BodyModel& neumann, const Side& second)
{
  return fmt::format("{}/{} and {}/{}", dirichlet.name, first.name, neumann.name, second.name);
}

InterfaceMesh firstSideOf(const InterfaceSettings& settings, const BodyModel& dirichlet,
                          const std::vector<Facet>& facets)
{
  InterfaceMesh interface = emptyInterface(settings.name, dirichlet);
  addSideFacets(interface, dirichlet.mesh, dirichlet.nodes, facets);
  return interface;
}

/// The nodes of the second side that are at those of the first.
void addPartners(InterfaceMesh& interface, const NodeMap& dirichlet, const Comparison& sides)
{
  for (std::size_t i = 0; i < interface.sides[0].nodes.size(); ++i) {
    interface.sides[1].nodes.push_back(sides.to.nodes[sides.nearest[i]]);
    const auto x = dirichlet.point(interface.sides[0].nodes[i]);
    interface.points.insert(interface.points.end(), x.begin(), x.begin() + interface.dim);
  }
}

Diagnostic liesOnNothing(const InterfaceSettings& settings, const Comparison& sides, const std::string& names)
{
  const auto nearest =
      std::size_t(std::min_element(sides.distance.begin(), sides.distance.end()) - sides.distance.begin());
  return settings.place.mistake(
      "", fmt::format("no part of one side lies on the other ({}): their nearest nodes are {:.3g} apart, at {}. Sides "
                      "of solids that are meshed independently touch where they are flat and lie on each other; curved "
                      "ones need the same nodes (one gmsh script with a common face).",
                      names, sides.distance[nearest],
                      pointText(sides.from.map.point(sides.from.nodes[nearest]).data(), 3)));
}

} // namespace

std::vector<std::pair<int, int>> commonVertices(const Mesh& first, const Side& firstSide, const Mesh& second,
                                                const Side& secondSide)
{
  const NodeMap firstMap = makeNodeMap(first, 1), secondMap = makeNodeMap(second, 1);
  const SideNodes mine{firstMap, sideNodes(firstMap, firstSide)}, theirs{secondMap, sideNodes(secondMap, secondSide)};
  const double tolerance = samePoint * std::min(shortestFacet(first, firstSide), shortestFacet(second, secondSide));
  const Comparison forward = compare(mine, theirs);
  std::vector<std::pair<int, int>> pairs;
  if (forward.largestDistance() > tolerance || compare(theirs, mine).largestDistance() > tolerance)
    return pairs;
  for (std::size_t i = 0; i < mine.nodes.size(); ++i)
    pairs.emplace_back(mine.nodes[i], theirs.nodes[forward.nearest[i]]);
  return pairs;
}

bool sidesMatch(const Mesh& first, const Side& firstSide, const Mesh& second, const Side& secondSide)
{
  if (commonVertices(first, firstSide, second, secondSide).empty())
    return false;
  const std::size_t count = firstSide.facets.size();
  return first.dim == 2 || (secondSide.facets.size() == count &&
                            commonFacets(first, firstSide, second, secondSide).firstFacets.size() == count);
}

InterfaceMesh pairSides(const InterfaceSettings& settings, const BodyModel& dirichlet, const BodyModel& neumann,
                        const ObstacleSurface* surface)
{
  Side first = findSide(settings, ContactRole::Dirichlet, dirichlet);
  if (surface != nullptr)
    first.facets = surface->facets;
  const Side& second = findSide(settings, ContactRole::Neumann, neumann);
  const std::string names = sideText(dirichlet, first, neumann, second);
  const SideNodes mine{dirichlet.nodes, nodesInOrder(dirichlet.nodes, first.facets)};
  const SideNodes theirs{neumann.nodes, sideNodes(neumann.nodes, second)};
  InterfaceMesh interface = firstSideOf(settings, dirichlet, first.facets);
  setNormal(interface, surface);
  const double tolerance =
      samePoint * std::min(shortestFacet(dirichlet.mesh, first), shortestFacet(neumann.mesh, second));
  const Comparison forward = compare(mine, theirs);
  if (forward.largestDistance() > tolerance)
    refuseOffset(settings, forward, interface.normals, names);
  refuseMissing(settings, forward, tolerance, names);
  refuseMissing(settings, compare(theirs, mine), tolerance, names);
  addPartners(interface, dirichlet.nodes, forward);
  if (!matchFacets(interface, neumann, second))
    throw InputError(otherFacets(settings, names));
  refuseSameSide(settings, interface, dirichlet, neumann);
  if (surface == nullptr) // a rigid body has the normal, or faces a flat side
    turnNormals(interface, dirichlet.mesh, settings.cornerAngle);
  evaluateGap(settings, interface, surface != nullptr ? surface->gap : std::string());
  return interface;
}

InterfaceMesh pairCutSides(const InterfaceSettings& settings, const BodyModel& dirichlet, const BodyModel& neumann)
{
  Side first = findSide(settings, ContactRole::Dirichlet, dirichlet),
       second = findSide(settings, ContactRole::Neumann, neumann);
  const std::string names = sideText(dirichlet, first, neumann, second);
  CommonFacets common = commonFacets(dirichlet.mesh, first, neumann.mesh, second);
  if (common.firstFacets.empty()) {
    const SideNodes mine{dirichlet.nodes, nodesInOrder(dirichlet.nodes, first.facets)};
    const SideNodes theirs{neumann.nodes, sideNodes(neumann.nodes, second)};
    const Comparison forward = compare(mine, theirs);
    refuseOffset(settings, forward, firstSideOf(settings, dirichlet, first.facets).normals, names);
    throw InputError(liesOnNothing(settings, forward, names));
  }
  first.facets = std::move(common.firstFacets);
  second.facets = std::move(common.secondFacets);
  const SideNodes mine{dirichlet.nodes, nodesInOrder(dirichlet.nodes, first.facets)};
  const SideNodes theirs{neumann.nodes, sideNodes(neumann.nodes, second)};
  InterfaceMesh interface = firstSideOf(settings, dirichlet, first.facets);
  addPartners(interface, dirichlet.nodes, compare(mine, theirs));
  if (!matchFacets(interface, neumann, second))
    throw InternalError("sides that were cut do not match");
  evaluateGap(settings, interface);
  interface.isCut = true;
  return interface;
}

} // namespace ndframe

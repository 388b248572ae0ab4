#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <nanoflann.hpp>

#include "ndframe/base/expression.hpp"
#include "ndframe/interface/interface_mesh.hpp"

namespace ndframe
{
namespace
{

/// Nodes of the two sides are one point when they are closer than this, relative to the shortest facet.
constexpr double sameNode = 1e-5;

/// The nodes of one side as nanoflann wants them.
struct NodeCloud
{
  const NodeMap& map;
  std::vector<int> nodes;

  std::size_t kdtree_get_point_count() const { return nodes.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t k) const { return map.point(nodes[i])[k]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const
  {
    return false;
  }
};

using Tree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, NodeCloud>, NodeCloud, -1, std::size_t>;

std::string position(const double* x, int dim)
{
  return dim == 2 ? fmt::format("({:g}, {:g})", x[0], x[1]) : fmt::format("({:g}, {:g}, {:g})", x[0], x[1], x[2]);
}

const Side& findSide(const Params& definition, const char* key, const BodyModel& body)
{
  const auto name = definition.get<std::string>(key);
  const Side* side = body.side(name);
  if (side == nullptr)
    throw InputError(definition.mistake(
        key, fmt::format("body \"{}\" has no side \"{}\"; {}.", body.name, name, sideNames(body.mesh))));
  return *side;
}

double shortestFacet(const BodyModel& body, const Side& side)
{
  double shortest = std::numeric_limits<double>::max(), normal[3];
  for (const Facet facet : side.facets)
    shortest = std::min(shortest, facetNormal(body.mesh, facet, normal));
  return body.mesh.dim == 2 ? shortest : std::sqrt(shortest);
}

/// For each node of `from` the index of the nearest one in `to` and the distance.
struct Nearest
{
  std::vector<std::size_t> index;
  std::vector<double> distance;
};

Nearest nearestNodes(const NodeCloud& from, const NodeCloud& to)
{
  const Tree tree(from.map.dim, to, nanoflann::KDTreeSingleIndexAdaptorParams(10));
  Nearest nearest;
  for (const int node : from.nodes) {
    std::size_t index = 0;
    double squared = 0.0;
    nanoflann::KNNResultSet<double> result(1);
    result.init(&index, &squared);
    tree.findNeighbors(result, from.map.point(node), nanoflann::SearchParams());
    nearest.index.push_back(index);
    nearest.distance.push_back(std::sqrt(squared));
  }
  return nearest;
}

/// Says how two sides miss each other: overlapping, apart along the normal, or with different nodes.
[[noreturn]] void reportMismatch(const Params& definition, const InterfaceMesh& interface, const NodeCloud& from,
                                 const NodeCloud& to, const Nearest& nearest, double tolerance, bool fromDirichlet,
                                 const std::string& names)
{
  const auto worst =
      std::size_t(std::max_element(nearest.distance.begin(), nearest.distance.end()) - nearest.distance.begin());
  const double* x = from.map.point(from.nodes[worst]);
  const double* y = to.map.point(to.nodes[nearest.index[worst]]);
  const double distance = nearest.distance[worst];
  if (fromDirichlet) {
    double along = 0.0;
    for (int k = 0; k < interface.dim; ++k)
      along += (y[k] - x[k]) * interface.normals[worst][std::size_t(k)];
    if (std::abs(along) > 0.999 * distance && along < 0.0)
      throw InputError(definition.mistake("", fmt::format("the bodies overlap at the start: by {:.3g} at {} ({}).",
                                                          distance, position(x, interface.dim), names)));
    if (std::abs(along) > 0.999 * distance)
      throw InputError(definition.mistake(
          "Gap",
          fmt::format("the sides are apart by {:.3g} at {} ({}); let the meshes touch and give the opening as Gap.",
                      distance, position(x, interface.dim), names)));
  }
  const auto missing =
      std::count_if(nearest.distance.begin(), nearest.distance.end(), [&](double d) { return d > tolerance; });
  throw InputError(definition.mistake(
      "",
      fmt::format("the sides do not match ({}): {} of {} nodes have no partner, the largest distance is {:.3g} at {}; "
                  "give both sides the same nodes (split the longer side).",
                  names, missing, nearest.distance.size(), distance, position(x, interface.dim))));
}

/// Node normals: the facets' normals weighted by their measure. Also numbers the facets' nodes.
void addFacets(InterfaceMesh& interface, const BodyModel& body, const Side& side)
{
  std::map<int, int> number;
  for (std::size_t i = 0; i < interface.dirichletNodes.size(); ++i)
    number[interface.dirichletNodes[i]] = int(i);
  interface.normals.assign(interface.dirichletNodes.size(), Direction{});
  int nodes[6];
  for (const Facet facet : side.facets) {
    Direction normal{};
    interface.measures.push_back(facetNormal(body.mesh, facet, normal.data()));
    interface.dirichletFacets.push_back(facet);
    facetNodes(body.nodes, facet, nodes);
    for (int a = 0; a < body.nodes.nodesPerFacet; ++a) {
      const int node = number.at(nodes[a]);
      interface.facets.push_back(node);
      for (std::size_t k = 0; k < 3; ++k)
        interface.normals[std::size_t(node)][k] += interface.measures.back() * normal[k];
    }
  }
  for (auto& normal : interface.normals) {
    const double length = std::sqrt(dotProduct(normal, normal));
    for (double& component : normal)
      component /= length;
  }
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
      nodes[a] = interface.neumannNodes[std::size_t(interface.facets[std::size_t(f) * nodes.size() + a])];
    std::sort(nodes.begin(), nodes.end());
    const auto found = byNodes.find(nodes);
    if (found == byNodes.end())
      return false;
    interface.neumannFacets.push_back(found->second);
  }
  return byNodes.size() == interface.measures.size();
}

void refuseSameSide(const Params& definition, const InterfaceMesh& interface, const BodyModel& dirichlet,
                    const BodyModel& neumann)
{
  for (int f = 0; f < interface.numFacets(); ++f) {
    Direction n1{}, n2{};
    facetNormal(dirichlet.mesh, interface.dirichletFacets[std::size_t(f)], n1.data());
    facetNormal(neumann.mesh, interface.neumannFacets[std::size_t(f)], n2.data());
    if (dotProduct(n1, n2) > 0.0)
      throw InputError(definition.mistake(
          "",
          fmt::format(
              "the bodies overlap at the start: \"{}\" and \"{}\" lie on the same side of the interface at {}.",
              dirichlet.name, neumann.name,
              position(interface.point(interface.facets[std::size_t(f * interface.nodesPerFacet())]), interface.dim))));
  }
}

void evaluateGap(const Params& definition, InterfaceMesh& interface)
{
  const Expression gap = definition.expression("Gap");
  double deepest = 0.0;
  int where = -1;
  for (int i = 0; i < interface.numNodes(); ++i) {
    const double* x = interface.point(i);
    interface.gap.push_back(gap(x[0], x[1], interface.dim == 3 ? x[2] : 0.0));
    if (!std::isfinite(interface.gap.back()))
      throw InputError(definition.mistake(
          "Gap", fmt::format("\"{}\" is {} at {}.", gap.text(), interface.gap.back(), position(x, interface.dim))));
    if (interface.gap.back() < deepest) {
      deepest = interface.gap.back();
      where = i;
    }
  }
  if (where >= 0)
    throw InputError(
        definition.mistake("Gap", fmt::format("the bodies overlap at the start: the gap is {:.3g} at {}; it must "
                                              "not be negative.",
                                              deepest, position(interface.point(where), interface.dim))));
}

} // namespace

InterfaceMesh pairSides(const Params& definition, const BodyModel& dirichlet, const BodyModel& neumann)
{
  const Side& first = findSide(definition, "Dirichlet Side", dirichlet);
  const Side& second = findSide(definition, "Neumann Side", neumann);
  InterfaceMesh interface;
  interface.name = definition.name();
  interface.dim = dirichlet.mesh.dim;
  interface.order = dirichlet.nodes.order;
  const NodeCloud mine{dirichlet.nodes, sideNodes(dirichlet.nodes, first)};
  const NodeCloud theirs{neumann.nodes, sideNodes(neumann.nodes, second)};
  interface.dirichletNodes = mine.nodes;
  addFacets(interface, dirichlet, first);

  const std::string names = fmt::format("{}/{} and {}/{}", dirichlet.name, first.name, neumann.name, second.name);
  const double tolerance = sameNode * std::min(shortestFacet(dirichlet, first), shortestFacet(neumann, second));
  const Nearest forward = nearestNodes(mine, theirs), backward = nearestNodes(theirs, mine);
  const auto misses = [tolerance](const Nearest& n) {
    return *std::max_element(n.distance.begin(), n.distance.end()) > tolerance;
  };
  if (misses(forward))
    reportMismatch(definition, interface, mine, theirs, forward, tolerance, true, names);
  if (misses(backward))
    reportMismatch(definition, interface, theirs, mine, backward, tolerance, false, names);
  for (std::size_t i = 0; i < mine.nodes.size(); ++i) {
    interface.neumannNodes.push_back(theirs.nodes[forward.index[i]]);
    const double* x = dirichlet.nodes.point(mine.nodes[i]);
    interface.points.insert(interface.points.end(), x, x + interface.dim);
  }
  if (!matchFacets(interface, neumann, second))
    throw InputError(
        definition.mistake("", fmt::format("the sides do not match ({}): they share their nodes but are cut into "
                                           "different facets.",
                                           names)));
  refuseSameSide(definition, interface, dirichlet, neumann);
  evaluateGap(definition, interface);
  return interface;
}

} // namespace ndframe

#include "side_facets.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "ndframe/base/expression.hpp"

namespace ndframe
{

const Side& findSide(const InterfaceSettings& settings, ContactRole role, const BodyModel& body)
{
  if (body.isRigid) // it has one side for every interface
    return *body.side(settings.name);
  const bool isDirichlet = role == ContactRole::Dirichlet;
  const char* const key = isDirichlet ? "Dirichlet Side" : "Neumann Side";
  if (!isDirichlet && !settings.neumannSide)
    throw InputError(
        settings.place.mistake(key, fmt::format("the key \"{}\" is missing; {}.", key, sideNames(body.mesh))));
  const std::string& name = isDirichlet ? settings.dirichletSide : *settings.neumannSide;
  const Side* side = body.side(name);
  if (side == nullptr)
    throw InputError(settings.place.mistake(
        key, fmt::format("body \"{}\" has no side \"{}\"; {}.", body.name, name, sideNames(body.mesh))));
  return *side;
}

InterfaceMesh emptyInterface(const std::string& name, const BodyModel& body)
{
  InterfaceMesh interface;
  interface.name = name;
  interface.dim = body.mesh.dim;
  interface.order = body.nodes.order;
  return interface;
}

std::vector<int> nodesInOrder(const NodeMap& nodes, const std::vector<Facet>& facets)
{
  std::vector<int> ordered = sideNodes(nodes, {"", facets});
  if (nodes.dim < 3)
    return ordered;
  std::vector<std::pair<Direction, int>> places;
  places.reserve(ordered.size());
  for (const int node : ordered)
    places.emplace_back(nodes.point(node), node);
  std::sort(places.begin(), places.end());
  std::transform(places.begin(), places.end(), ordered.begin(), [](const auto& place) { return place.second; });
  return ordered;
}

void addSideFacets(InterfaceMesh& interface, const Mesh& mesh, const NodeMap& nodes, const std::vector<Facet>& facets)
{
  if (interface.sides[0].nodes.empty())
    interface.sides[0].nodes = nodesInOrder(nodes, facets);
  std::map<int, int> number;
  for (std::size_t i = 0; i < interface.sides[0].nodes.size(); ++i)
    number[interface.sides[0].nodes[i]] = int(i);
  int ofFacet[6];
  for (const Facet facet : facets) {
    facetNodes(nodes, facet, ofFacet);
    for (int a = 0; a < nodes.nodesPerFacet; ++a)
      interface.facets.push_back(number.at(ofFacet[a]));
  }
  addNormals(interface, mesh, facets);
}

void addNormals(InterfaceMesh& interface, const Mesh& mesh, const std::vector<Facet>& facets)
{
  interface.sides[0].facets = facets;
  for (const Facet facet : facets) {
    interface.facetNormals.emplace_back();
    interface.measures.push_back(facetNormal(mesh, facet, interface.facetNormals.back().data()));
  }
  setMeanNormals(interface);
}

void setMeanNormals(InterfaceMesh& interface)
{
  interface.normals.assign(interface.sides[0].nodes.size(), Direction{});
  for (int f = 0; f < interface.numFacets(); ++f)
    for (int a = 0; a < interface.nodesPerFacet(); ++a)
      for (std::size_t k = 0; k < 3; ++k)
        interface.normals[std::size_t(interface.nodesOf(f)[a])][k] +=
            interface.measures[std::size_t(f)] * interface.facetNormals[std::size_t(f)][k];
  for (auto& normal : interface.normals) {
    const double length = std::sqrt(dotProduct(normal, normal));
    for (double& component : normal)
      component /= length;
  }
}

void evaluateGap(const InterfaceSettings& settings, InterfaceMesh& interface, const std::string& more)
{
  const Expression gap(more.empty() ? settings.gap : fmt::format("({})+({})", settings.gap, more));
  interface.gapFunction = sampledFunction(settings.place, "Gap", gap.text());
  constexpr double roundOff = 1e-13; // of coordinates, in formulas of obstacles
  double deepest = more.empty() ? 0.0 : -roundOff * largestEntry(interface.points);
  int where = -1;
  for (int i = 0; i < interface.numNodes(); ++i) {
    const double* x = interface.point(i);
    interface.gap.push_back(gap(x[0], x[1], interface.dim == 3 ? x[2] : 0.0));
    if (!std::isfinite(interface.gap.back()))
      throw InputError(settings.place.mistake(
          "Gap", fmt::format("Gap = \"{}\" is {} at {}; it must be finite on the whole side.", gap.text(),
                             std::abs(interface.gap.back()), pointText(x, interface.dim))));
    if (interface.gap.back() < deepest) {
      deepest = interface.gap.back();
      where = i;
    }
  }
  if (where >= 0)
    throw InputError(
        settings.place.mistake("Gap", fmt::format("the bodies overlap at the start: the gap is {:.3g} at {}; it must "
                                                  "not be negative.",
                                                  deepest, pointText(interface.point(where), interface.dim))));
}

} // namespace ndframe

#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>

#include "checks.hpp"
#include "ndframe/mesh/boundary.hpp"

namespace ndframe
{
namespace
{

/// The boundaries beyond the side open by less than this angle (cosine of 30 degrees): they might touch, too.
constexpr double narrow = 0.866;
constexpr double pressed = 1e-9; ///< of the largest force of the interface

/// The end of a side: a vertex in the plane, an edge in space.
using Rim = std::vector<int>;

/// The rims of a facet, each with the vertex that is opposite to it.
std::vector<std::pair<Rim, int>> rimsOf(const Mesh& mesh, Facet facet)
{
  int vertices[3];
  facetVertices(mesh, facet, vertices);
  std::vector<std::pair<Rim, int>> rims;
  for (int left = 0; left < mesh.dim; ++left) {
    Rim rim;
    for (int v = 0; v < mesh.dim; ++v)
      if (v != left)
        rim.push_back(vertices[v]);
    std::sort(rim.begin(), rim.end());
    rims.emplace_back(rim, vertices[left]);
  }
  return rims;
}

/// Unit vector from a rim into a facet that it bounds, square to the rim.
Direction awayFrom(const Mesh& mesh, const Rim& rim, int opposite)
{
  Direction away{}, along{};
  for (std::size_t k = 0; k < std::size_t(mesh.dim); ++k) {
    away[k] = mesh.point(opposite)[k] - mesh.point(rim[0])[k];
    along[k] = rim.size() > 1 ? mesh.point(rim[1])[k] - mesh.point(rim[0])[k] : 0.0;
  }
  const double squared = dotProduct(along, along), share = squared > 0.0 ? dotProduct(away, along) / squared : 0.0;
  for (std::size_t k = 0; k < 3; ++k)
    away[k] -= share * along[k];
  const double length = std::sqrt(dotProduct(away, away));
  for (double& component : away)
    component /= length;
  return away;
}

/// How the boundary of a body goes on beyond a side: per rim of the side the direction of the next facet.
std::map<Rim, Direction> beyond(const Mesh& mesh, const std::vector<Facet>& side)
{
  std::set<std::pair<int, int>> inside;
  std::map<Rim, int> count; // a rim inside the side has two of its facets
  for (const Facet facet : side) {
    inside.insert({facet.cell, facet.local});
    for (const auto& [rim, opposite] : rimsOf(mesh, facet))
      ++count[rim];
  }
  std::map<Rim, Direction> next;
  for (const Facet facet : boundaryFacets(mesh)) {
    if (inside.count({facet.cell, facet.local}) > 0)
      continue;
    for (const auto& [rim, opposite] : rimsOf(mesh, facet))
      if (const auto found = count.find(rim); found != count.end() && found->second == 1)
        next[rim] = awayFrom(mesh, rim, opposite);
  }
  return next;
}

/// Interface nodes that are closed and pressed, by their number in the Dirichlet body, with that in the Neumann body.
std::map<int, int> pressedNodes(const InterfaceMesh& interface, const ContactNode* contact)
{
  double largest = 0.0;
  for (int i = 0; i < interface.numNodes(); ++i)
    largest = std::max(largest, -contact[i].nodalForce);
  std::map<int, int> nodes;
  for (int i = 0; i < interface.numNodes(); ++i)
    if (contact[i].closed && largest > 0.0 && -contact[i].nodalForce > pressed * largest)
      nodes[interface.dirichlet().nodes[std::size_t(i)]] = interface.neumann().nodes[std::size_t(i)];
  return nodes;
}

/// A pressed rim beyond which both boundaries go on close to each other; empty if there is none.
Rim openRim(const Model& model, const InterfaceMesh& interface, const ContactNode* contact)
{
  const auto nodes = pressedNodes(interface, contact);
  const auto first = beyond(model.bodies[std::size_t(interface.dirichlet().body)].mesh, interface.dirichlet().facets);
  const auto second = beyond(model.bodies[std::size_t(interface.neumann().body)].mesh, interface.neumann().facets);
  for (const auto& [rim, direction] : first) {
    Rim other;
    for (const int vertex : rim)
      if (const auto found = nodes.find(vertex); found != nodes.end())
        other.push_back(found->second);
    std::sort(other.begin(), other.end());
    const auto found = second.find(other);
    if (other.size() == rim.size() && found != second.end() && dotProduct(direction, found->second) > narrow)
      return rim;
  }
  return {};
}

} // namespace

/// Contact that presses at the end of the named sides would go on where nobody looks for it.
void findContactAtEnds(const Answer& answer, const RunSettings& settings, Diagnostics& found)
{
  const Run& run = answer.run;
  const ContactNode* contact = run.solved.contact.data();
  for (const auto& interface : run.model.interfaces) {
    const Mesh& mesh = run.model.bodies[std::size_t(interface.dirichlet().body)].mesh;
    if (const Rim rim = openRim(run.model, interface, contact); !rim.empty())
      found.add(
          settings.scene.interface(interface.name)
              .place.mistake(
                  "", fmt::format(
                          "there is contact pressure at the end of the sides, at {}, and the boundaries of both bodies "
                          "continue close to each other: they may touch beyond the sides. Make the sides longer.",
                          pointText(mesh.point(rim.front()), mesh.dim))));
    contact += interface.numNodes();
  }
}

} // namespace ndframe

#include "interface_star.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "ndframe/admissibility/turning_normal.hpp"
#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

/// A vertex of the mesh on a facet, by its place among the facet's ascending vertices.
int meshVertex(const Mesh& mesh, Facet facet, int place)
{
  int vertices[2];
  facetVertices(mesh, facet, vertices);
  return place == 0 ? std::min(vertices[0], vertices[1]) : std::max(vertices[0], vertices[1]);
}

/// The first end of a facet as seen along n_c turned by 90 degrees.
int firstEnd(const RecoveryScene& scene, const ContactFacet& facet)
{
  const Mesh& mesh = scene.bodies[std::size_t(facet.dirichletBody)]->mesh;
  const double *a = mesh.point(meshVertex(mesh, facet.dirichlet, 0)),
               *b = mesh.point(meshVertex(mesh, facet.dirichlet, 1));
  return (b[1] - a[1]) * facet.normal[0] - (b[0] - a[0]) * facet.normal[1] > 0.0 ? 0 : 1;
}

/// How the released tractions on the facets of a vertex follow from t_N, facet after facet. The Neumann body's own
/// modes run backwards on reversed facets.
DenseMatrix releasedByTraction(const RecoveryScene& scene, const InterfaceVertex& vertex, int modes, bool isNeumann)
{
  int rows = 0;
  for (const FacetEnd& end : vertex.ends)
    rows += (scene.facets[std::size_t(end.facet)].turns ? 2 : 1) * modes;
  DenseMatrix map(rows, int(vertex.ends.size()) * modes);
  const EndTables turning = turningModes(modes - 1, modes - 1);
  int row = 0, col = 0;
  for (const FacetEnd& end : vertex.ends) {
    const ContactFacet& facet = scene.facets[std::size_t(end.facet)];
    const auto sign = [&](int k) { return (isNeumann && facet.isReversed() && k % 2 == 1) != isNeumann ? -1.0 : 1.0; };
    for (int k = 0; !facet.turns && k < modes; ++k)
      map(row + k, col + k) = sign(k);
    for (int d = 0; facet.turns && d < 2; ++d)
      for (int k = 0; k < modes; ++k)
        for (int j = 0; j < modes; ++j)
          for (std::size_t e = 0; e < 2; ++e)
            map(row + d * modes + k, col + j) += sign(k) * facet.ends[e][std::size_t(d)] * turning[e](k, j);
    row += (facet.turns ? 2 : 1) * modes;
    col += modes;
  }
  return map;
}

/// Body `isNeumann` of the facets at a vertex.
InterfaceStar::Side makeSide(const RecoveryScene& scene, const std::vector<const StarBody*>& bodies,
                             const InterfaceVertex& vertex, bool isNeumann)
{
  std::vector<ReleasedFacet> released;
  int body = -1, meshPoint = -1;
  for (const FacetEnd& end : vertex.ends) {
    const ContactFacet& facet = scene.facets[std::size_t(end.facet)];
    const Facet own = isNeumann ? facet.neumann : facet.dirichlet;
    body = isNeumann ? facet.neumannBody : facet.dirichletBody;
    if (facet.turns)
      released.insert(released.end(), {{own, {1.0, 0.0, 0.0}}, {own, {0.0, 1.0, 0.0}}});
    else
      released.push_back({own, facet.normal});
    meshPoint = meshVertex(bodies[std::size_t(body)]->model().mesh, own,
                           isNeumann && facet.isReversed() ? 1 - end.vertex : end.vertex);
  }
  const StarBody& star = *bodies[std::size_t(body)];
  return {body, StarSystem(star, star.star(meshPoint), released),
          releasedByTraction(scene, vertex, star.facetModes(), isNeumann)};
}

} // namespace

std::vector<InterfaceVertex> interfaceVertices(const RecoveryScene& scene)
{
  std::map<int, std::vector<FacetEnd>> ends; // by interface node
  std::map<int, int> next;
  std::set<int> followers;
  std::vector<int> starts;
  for (std::size_t f = 0; f < scene.facets.size(); ++f) {
    const auto& nodes = scene.facets[f].pairs;
    for (const int vertex : {0, 1})
      ends[nodes[std::size_t(vertex)]].push_back({int(f), vertex});
    const int first = firstEnd(scene, scene.facets[f]);
    next[nodes[std::size_t(first)]] = nodes[std::size_t(1 - first)];
    followers.insert(nodes[std::size_t(1 - first)]);
    starts.push_back(nodes[std::size_t(first)]);
  }
  // open chains from their beginnings, then whatever is closed
  std::stable_partition(starts.begin(), starts.end(), [&](int node) { return followers.count(node) == 0; });
  std::vector<InterfaceVertex> vertices;
  for (int node : starts)
    for (auto found = ends.find(node); found != ends.end(); found = ends.find(node)) {
      vertices.push_back({std::move(found->second)});
      ends.erase(found);
      if (const auto follower = next.find(node); follower != next.end())
        node = follower->second;
    }
  return vertices;
}

InterfaceStar::InterfaceStar(const RecoveryScene& scene, const std::vector<const StarBody*>& bodies,
                             const InterfaceVertex& vertex)
    : scene_(scene), vertex_(vertex)
{
  const ContactFacet& facet = scene.facets[std::size_t(vertex.ends.front().facet)];
  for (const auto& [body, isNeumann] : {std::pair(facet.dirichletBody, false), std::pair(facet.neumannBody, true)})
    if (!scene.bodies[std::size_t(body)]->isRigid)
      sides_.push_back(makeSide(scene, bodies, vertex, isNeumann));
}

TractionStep InterfaceStar::step(const std::vector<StarFields>& x, const Vector& opening) const
{
  const int size = sides_.front().released.cols(), modes = size / int(vertex_.ends.size());
  std::vector<DenseMatrix> rows;
  int numRows = 0;
  for (const Side& side : sides_) {
    rows.push_back(multiply(side.system.conditions(), side.released));
    numRows += rows.back().rows();
  }
  DenseMatrix E(numRows, size), H(size, size);
  Vector h;
  for (int i = 0; i < size; ++i) {
    const FacetEnd& end = vertex_.ends[std::size_t(i / modes)];
    h.push_back(opening[std::size_t(end.facet) * std::size_t(modes) + std::size_t(i % modes)] /
                scene_.facets[std::size_t(end.facet)].measure);
  }
  for (std::size_t s = 0, first = 0; s < sides_.size(); first += std::size_t(rows[s++].rows())) {
    const Side& side = sides_[s];
    const DenseMatrix gradient = multiplyTransposed(side.released, side.system.gradient(x[s]));
    const DenseMatrix stiffness = multiplyTransposed(side.released, multiply(side.system.stiffness(), side.released));
    for (int j = 0; j < size; ++j) {
      h[std::size_t(j)] += gradient(j, 0);
      for (int i = 0; i < size; ++i)
        H(i, j) += stiffness(i, j);
      for (int i = 0; i < rows[s].rows(); ++i)
        E(int(first) + i, j) = rows[s](i, j);
    }
  }
  return TractionStep(vertex_.ends, E, std::move(H), std::move(h));
}

} // namespace ndframe

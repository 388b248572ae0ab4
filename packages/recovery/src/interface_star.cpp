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

/// The vertex of a body at an end of a contact facet.
int vertexOf(const Mesh& mesh, const ContactFacet& facet, const FacetEnd& end, bool isNeumann)
{
  return meshVertex(mesh, isNeumann ? facet.neumann : facet.dirichlet,
                    isNeumann && facet.isReversed() ? 1 - end.vertex : end.vertex);
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

/// The facets at a vertex as the Dirichlet or the Neumann body sees them.
std::vector<ReleasedFacet> releasedFacets(const RecoveryScene& scene, const InterfaceVertex& vertex, bool isNeumann)
{
  std::vector<ReleasedFacet> released;
  for (const FacetEnd& end : vertex.ends) {
    const ContactFacet& facet = scene.facets[std::size_t(end.facet)];
    const Facet own = isNeumann ? facet.neumann : facet.dirichlet;
    if (facet.turns)
      released.insert(released.end(), {{own, {1.0, 0.0, 0.0}}, {own, {0.0, 1.0, 0.0}}});
    else
      released.push_back({own, facet.normal});
  }
  return released;
}

DenseMatrix stacked(const DenseMatrix& above, const DenseMatrix& below)
{
  DenseMatrix both(above.rows() + below.rows(), above.cols());
  for (int j = 0; j < both.cols(); ++j) {
    std::copy_n(above.col(j), above.rows(), both.col(j));
    std::copy_n(below.col(j), below.rows(), both.col(j) + above.rows());
  }
  return both;
}

/// One body's part of a vertex: as Dirichlet body, as Neumann body, or, where a slit ends, as both.
InterfaceStar::Side makeSide(const RecoveryScene& scene, const std::vector<const StarBody*>& bodies,
                             const InterfaceVertex& vertex, bool isNeumann, bool isBoth = false)
{
  const FacetEnd& end = vertex.ends.front();
  const ContactFacet& facet = scene.facets[std::size_t(end.facet)];
  const int body = facet.body(!isNeumann);
  const StarBody& star = *bodies[std::size_t(body)];
  std::vector<ReleasedFacet> released = releasedFacets(scene, vertex, isNeumann);
  DenseMatrix map = releasedByTraction(scene, vertex, star.facetModes(), isNeumann);
  if (isBoth) {
    const auto others = releasedFacets(scene, vertex, !isNeumann);
    released.insert(released.end(), others.begin(), others.end());
    map = stacked(map, releasedByTraction(scene, vertex, star.facetModes(), !isNeumann));
  }
  const int point = vertexOf(star.model().mesh, facet, end, isNeumann);
  return {body, StarSystem(star, star.star(point), released), std::move(map)};
}

/// A vertex that faces itself.
bool isSlitEnd(const RecoveryScene& scene, const InterfaceVertex& vertex)
{
  const FacetEnd& end = vertex.ends.front();
  const ContactFacet& facet = scene.facets[std::size_t(end.facet)];
  const Mesh& mesh = scene.bodies[std::size_t(facet.dirichletBody)]->mesh;
  return facet.dirichletBody == facet.neumannBody &&
         vertexOf(mesh, facet, end, false) == vertexOf(mesh, facet, end, true);
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

bool starsMeet(const RecoveryScene& scene, const std::vector<const StarBody*>& bodies, const InterfaceVertex& vertex)
{
  const FacetEnd& end = vertex.ends.front();
  const ContactFacet& facet = scene.facets[std::size_t(end.facet)];
  if (facet.dirichletBody != facet.neumannBody || isSlitEnd(scene, vertex))
    return false;
  const StarBody& body = *bodies[std::size_t(facet.dirichletBody)];
  const Mesh& mesh = body.model().mesh;
  const auto cells = [&](bool isNeumann) {
    std::set<int> found;
    for (const StarCell& part : body.star(vertexOf(mesh, facet, end, isNeumann)).cells)
      found.insert(part.cell);
    return found;
  };
  const std::set<int> ours = cells(false), theirs = cells(true);
  return std::find_first_of(ours.begin(), ours.end(), theirs.begin(), theirs.end()) != ours.end();
}

InterfaceStar::InterfaceStar(const RecoveryScene& scene, const std::vector<const StarBody*>& bodies,
                             const InterfaceVertex& vertex)
    : scene_(scene), vertex_(vertex)
{
  const ContactFacet& facet = scene.facets[std::size_t(vertex.ends.front().facet)];
  if (isSlitEnd(scene, vertex)) {
    sides_.push_back(makeSide(scene, bodies, vertex, false, true));
    return;
  }
  for (const bool isNeumann : {false, true})
    if (!scene.bodies[std::size_t(facet.body(!isNeumann))]->isRigid)
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

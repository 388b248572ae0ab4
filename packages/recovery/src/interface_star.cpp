#include "interface_star.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "ndframe/admissibility/contact_nodes.hpp"
#include "ndframe/admissibility/turning_normal.hpp"
#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

/// The vertex of a body at an end of a patch.
int vertexOf(const RecoveryScene& scene, const PatchEnd& end, std::size_t side)
{
  const PatchSide& own = scene.patches[std::size_t(end.patch)].sides[side];
  return contactNodes(*scene.bodies[std::size_t(own.body)], own)[std::size_t(end.vertex)];
}

/// The first end of a patch as seen along n_c turned by 90 degrees.
int firstEnd(const RecoveryScene& scene, int patch)
{
  const ContactPatch& own = scene.patches[std::size_t(patch)];
  const Mesh& mesh = scene.bodies[std::size_t(own.sides[0].body)]->mesh;
  const double *a = mesh.point(vertexOf(scene, {patch, 0}, 0)), *b = mesh.point(vertexOf(scene, {patch, 1}, 0));
  return (b[1] - a[1]) * own.normal[0] - (b[0] - a[0]) * own.normal[1] > 0.0 ? 0 : 1;
}

/// How the tractions released on one side of a vertex's patches follow from t_N, patch after patch, in the body's own
/// modes.
DenseMatrix releasedByTraction(const RecoveryScene& scene, const InterfaceVertex& vertex, int modes, std::size_t side)
{
  int rows = 0;
  for (const PatchEnd& end : vertex.ends)
    rows += (scene.patches[std::size_t(end.patch)].turns ? 2 : 1) * modes;
  DenseMatrix map(rows, int(vertex.ends.size()) * modes);
  const EndTables turning = turningModes(2, modes - 1, modes - 1);
  OrderedModes inOrder(2, modes - 1);
  int row = 0, col = 0;
  const auto add = [&](const DenseMatrix& block, double factor) {
    for (int j = 0; j < modes; ++j)
      for (int k = 0; k < modes; ++k)
        map(row + k, col + j) += sideSign(side) * factor * block(k, j);
  };
  for (const PatchEnd& end : vertex.ends) {
    const ContactPatch& patch = scene.patches[std::size_t(end.patch)];
    const DenseMatrix& own = inOrder(patch.sides[side]);
    if (!patch.turns) {
      add(own, 1.0);
      row += modes;
    }
    for (std::size_t d = 0; patch.turns && d < 2; ++d, row += modes)
      for (std::size_t e = 0; e < 2; ++e)
        add(multiply(own, turning[e]), patch.ends[e][d]);
    col += modes;
  }
  return map;
}

/// The facets of a vertex as the body on one side sees them.
std::vector<ReleasedFacet> releasedFacets(const RecoveryScene& scene, const InterfaceVertex& vertex, std::size_t side)
{
  std::vector<ReleasedFacet> released;
  for (const PatchEnd& end : vertex.ends) {
    const ContactPatch& patch = scene.patches[std::size_t(end.patch)];
    const Facet own = patch.sides[side].facet;
    if (patch.turns)
      released.insert(released.end(), {{own, {1.0, 0.0, 0.0}}, {own, {0.0, 1.0, 0.0}}});
    else
      released.push_back({own, patch.normal});
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

/// One body's part of a vertex: on one side, or, where a slit ends, on both.
InterfaceStar::Side makeSide(const RecoveryScene& scene, const std::vector<const StarBody*>& bodies,
                             const InterfaceVertex& vertex, const std::vector<std::size_t>& sides)
{
  const PatchEnd& end = vertex.ends.front();
  const int body = scene.patches[std::size_t(end.patch)].sides[sides.front()].body;
  const StarBody& star = *bodies[std::size_t(body)];
  const int modes = star.facetModes();
  std::vector<ReleasedFacet> released;
  DenseMatrix map(0, int(vertex.ends.size()) * modes);
  for (const std::size_t side : sides) {
    const auto own = releasedFacets(scene, vertex, side);
    released.insert(released.end(), own.begin(), own.end());
    map = stacked(map, releasedByTraction(scene, vertex, modes, side));
  }
  return {body, StarSystem(star, star.star(vertexOf(scene, end, sides.front())), released), std::move(map)};
}

/// A vertex that faces itself.
bool isSlitEnd(const RecoveryScene& scene, const InterfaceVertex& vertex)
{
  const PatchEnd& end = vertex.ends.front();
  return scene.patches[std::size_t(end.patch)].touchesItself() && vertexOf(scene, end, 0) == vertexOf(scene, end, 1);
}

} // namespace

std::vector<InterfaceVertex> interfaceVertices(const RecoveryScene& scene)
{
  std::map<int, std::vector<PatchEnd>> ends; // by interface node
  std::map<int, int> next;
  std::set<int> followers;
  std::vector<int> starts;
  for (std::size_t f = 0; f < scene.patches.size(); ++f) {
    const auto& nodes = scene.patches[f].pairs;
    for (const int vertex : {0, 1})
      ends[nodes[std::size_t(vertex)]].push_back({int(f), vertex});
    const int first = firstEnd(scene, int(f));
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
  const PatchEnd& end = vertex.ends.front();
  const ContactPatch& patch = scene.patches[std::size_t(end.patch)];
  if (!patch.touchesItself() || isSlitEnd(scene, vertex))
    return false;
  const StarBody& body = *bodies[std::size_t(patch.sides[0].body)];
  const auto cells = [&](std::size_t side) {
    std::set<int> found;
    for (const StarCell& part : body.star(vertexOf(scene, end, side)).cells)
      found.insert(part.cell);
    return found;
  };
  const std::set<int> ours = cells(0), theirs = cells(1);
  return std::find_first_of(ours.begin(), ours.end(), theirs.begin(), theirs.end()) != ours.end();
}

InterfaceStar::InterfaceStar(const RecoveryScene& scene, const std::vector<const StarBody*>& bodies,
                             const InterfaceVertex& vertex)
    : scene_(scene), vertex_(vertex)
{
  const ContactPatch& patch = scene.patches[std::size_t(vertex.ends.front().patch)];
  if (isSlitEnd(scene, vertex)) {
    sides_.push_back(makeSide(scene, bodies, vertex, {0, 1}));
    return;
  }
  for (const std::size_t side : {0u, 1u})
    if (!scene.bodies[std::size_t(patch.sides[side].body)]->isRigid)
      sides_.push_back(makeSide(scene, bodies, vertex, {side}));
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
    const PatchEnd& end = vertex_.ends[std::size_t(i / modes)];
    h.push_back(opening[std::size_t(end.patch) * std::size_t(modes) + std::size_t(i % modes)] /
                scene_.patches[std::size_t(end.patch)].measure);
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

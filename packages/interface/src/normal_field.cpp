#include "ndframe/interface/normal_field.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "facet_tree.hpp"
#include "ndframe/fem/lagrange.hpp"
#include "ndframe/mesh/surface_normals.hpp"
#include "side_facets.hpp"

namespace ndframe
{
namespace
{

/// A side that turns by less (radians) at a vertex goes straight on: coordinates in files have some digits only.
constexpr double straightOn = 1e-6;
/// A facet lies on another one if its ends do, relative to the other's length; nearer than the second it is one's end.
constexpr double onFacet = 1e-6, sameEnd = 1e-9;

Direction combine(double a, const Direction& x, double b, const Direction& y)
{
  return {a * x[0] + b * y[0], a * x[1] + b * y[1], a * x[2] + b * y[2]};
}

Direction crossProduct(const Direction& a, const Direction& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

bool isZero(const Direction& d)
{
  return dotProduct(d, d) == 0.0;
}

/// Finds what every vertex of a side is and turns its facets.
class TurningSide
{
public:
  TurningSide(InterfaceMesh& mesh, const Mesh& dirichletMesh) : mesh_(mesh), around_(std::size_t(mesh.numNodes()))
  {
    for (int f = 0; f < mesh.numFacets(); ++f) {
      own_.emplace_back();
      facetNormal(dirichletMesh, mesh.sides[0].facets[std::size_t(f)], own_.back().data());
      for (const int end : {0, 1})
        around_[std::size_t(vertex(f, end))].push_back(f);
    }
  }

  void turn(double cornerAngle)
  {
    std::vector<VertexNormals> ends(own_.size());
    bool turns = false;
    for (int f = 0; f < mesh_.numFacets(); ++f) {
      ends[std::size_t(f)] = endsOf(f, cornerAngle);
      turns = turns || !isZero(ends[std::size_t(f)][0]);
    }
    if (turns)
      mesh_.endNormals = std::move(ends);
  }

  /// The corners: vertices where the side turns by more than the angle.
  std::vector<int> corners(double cornerAngle) const
  {
    std::vector<int> found;
    for (int node = 0; node < mesh_.numNodes(); ++node)
      if (around_[std::size_t(node)].size() == 2 && kind(node, cornerAngle) == Kind::Open)
        found.push_back(node);
    return found;
  }

  /// n_c of a facet at one of its vertices.
  Direction valueAt(int facet, int node) const
  {
    if (mesh_.endNormals.empty())
      return own_[std::size_t(facet)];
    const Direction& end = mesh_.endNormals[std::size_t(facet)][vertex(facet, 0) == node ? 0 : 1];
    return isZero(end) ? own_[std::size_t(facet)] : end;
  }

  /// One more node for a corner, which its second facet gets.
  void split(int corner)
  {
    const auto at = std::size_t(corner);
    const int twin = mesh_.numNodes(), first = around_[at][0], second = around_[at][1];
    const Direction ofFirst = valueAt(first, corner), ofSecond = valueAt(second, corner);
    mesh_.sides[0].nodes.push_back(mesh_.sides[0].nodes[at]);
    mesh_.sides[1].nodes.push_back(mesh_.sides[1].nodes[at]);
    for (int k = 0; k < mesh_.dim; ++k)
      mesh_.points.push_back(mesh_.point(corner)[k]);
    for (int k = 0; k < mesh_.dim && !mesh_.partners.empty(); ++k)
      mesh_.partners.push_back(mesh_.partners[at * std::size_t(mesh_.dim) + std::size_t(k)]);
    if (!mesh_.apart.empty())
      mesh_.apart.push_back(mesh_.apart[at]);
    mesh_.gap.push_back(mesh_.gap[at]);
    mesh_.normals[at] = ofFirst;
    mesh_.normals.push_back(ofSecond);
    const auto nodes = mesh_.facets.begin() + std::ptrdiff_t(second) * std::ptrdiff_t(mesh_.nodesPerFacet());
    std::replace(nodes, nodes + mesh_.nodesPerFacet(), corner, twin);
  }

private:
  enum class Kind
  {
    Open, ///< an end of the side or a corner
    Straight,
    Turning
  };

  int vertex(int facet, int end) const { return mesh_.nodesOf(facet)[end]; }

  Kind kind(int node, double cornerAngle) const
  {
    const auto& facets = around_[std::size_t(node)];
    if (facets.size() != 2)
      return Kind::Open;
    const Direction &a = own_[std::size_t(facets[0])], &b = own_[std::size_t(facets[1])];
    const double turned = std::abs(std::atan2(a[0] * b[1] - a[1] * b[0], dotProduct(a, b)));
    if (turned <= straightOn)
      return Kind::Straight;
    return turned > cornerAngle * std::acos(-1.0) / 180.0 ? Kind::Open : Kind::Turning;
  }

  Direction normalAt(int node) const
  {
    const auto& facets = around_[std::size_t(node)];
    const auto first = std::size_t(facets[0]), second = std::size_t(facets[1]);
    const Direction sum = combine(mesh_.measures[second], own_[first], mesh_.measures[first], own_[second]);
    return combine(2.0 / (dotProduct(sum, own_[first]) + dotProduct(sum, own_[second])), sum, 0.0, sum);
  }

  VertexNormals endsOf(int facet, double cornerAngle) const
  {
    const Direction& own = own_[std::size_t(facet)];
    VertexNormals ends{own, own};
    std::array<Kind, 2> kinds{};
    for (const std::size_t end : {0u, 1u}) {
      kinds[end] = kind(vertex(facet, int(end)), cornerAngle);
      if (kinds[end] == Kind::Turning)
        ends[end] = normalAt(vertex(facet, int(end)));
    }
    if (kinds[0] != Kind::Turning && kinds[1] != Kind::Turning)
      return {};
    for (const std::size_t end : {0u, 1u})
      if (kinds[end] == Kind::Open)
        ends[end] = combine(2.0 * dotProduct(own, ends[1 - end]), own, -1.0, ends[1 - end]);
    return ends;
  }

  InterfaceMesh& mesh_;
  std::vector<Direction> own_;           ///< the facets' normals
  std::vector<std::vector<int>> around_; ///< a vertex's facets
};

/// The field on a side of a solid.
std::vector<VertexNormals> onTriangles(const InterfaceMesh& mesh, double cornerAngle)
{
  TriangleSurface surface{{}, {}, mesh.facetNormals};
  for (int i = 0; i < mesh.numNodes(); ++i)
    surface.points.push_back({mesh.point(i)[0], mesh.point(i)[1], mesh.point(i)[2]});
  for (int f = 0; f < mesh.numFacets(); ++f)
    surface.triangles.push_back({mesh.nodesOf(f)[0], mesh.nodesOf(f)[1], mesh.nodesOf(f)[2]});
  return turningNormals(surface, cornerAngle);
}

/// Barycentric coordinates of a point on a segment; nothing beside it.
std::optional<std::array<double, 3>> placeOn(const double* a, const double* b, const double* x)
{
  const double dx = b[0] - a[0], dy = b[1] - a[1], squared = dx * dx + dy * dy;
  const double along = ((x[0] - a[0]) * dx + (x[1] - a[1]) * dy) / squared;
  const double beside = ((x[0] - a[0]) * dy - (x[1] - a[1]) * dx) / squared;
  if (!(std::abs(beside) <= onFacet && along >= -onFacet && along <= 1.0 + onFacet))
    return std::nullopt;
  const double place = std::abs(along) <= sameEnd ? 0.0 : std::abs(along - 1.0) <= sameEnd ? 1.0 : along;
  return std::array{1.0 - place, place, 0.0};
}

/// The same on a triangle.
std::optional<std::array<double, 3>> placeOn(const std::array<const double*, 3>& corners, const double* x)
{
  std::array<Direction, 3> to{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      to[i][k] = corners[i][k] - x[k];
  const auto normal = [&](std::size_t i) { // of the triangle without vertex i, twice its area long
    return crossProduct(to[(i + 1) % 3], to[(i + 2) % 3]);
  };
  const Direction whole = combine(1.0, combine(1.0, normal(0), 1.0, normal(1)), 1.0, normal(2));
  const double squared = dotProduct(whole, whole), beside = dotProduct(to[0], whole) / std::pow(squared, 0.75);
  std::array<double, 3> place{};
  for (std::size_t i = 0; i < 3; ++i) {
    place[i] = dotProduct(normal(i), whole) / squared;
    for (const double end : {0.0, 1.0})
      place[i] = std::abs(place[i] - end) <= sameEnd ? end : place[i];
    if (!(place[i] >= -onFacet))
      return std::nullopt;
  }
  return std::abs(beside) <= onFacet ? std::optional(place) : std::nullopt;
}

/// n in the middle of a facet's edge.
Direction middleOf(const VertexNormals& ends, int dim, int edge)
{
  const auto [a, b] = dim == 2 ? SimplexEdges<1>::vertices[0] : SimplexEdges<2>::vertices[std::size_t(edge)];
  return combine(0.5, ends[std::size_t(a)], 0.5, ends[std::size_t(b)]);
}

} // namespace

void setNodeNormals(InterfaceMesh& mesh)
{
  const int nodes = mesh.nodesPerFacet();
  std::vector<Direction> value(mesh.normals.size());
  std::vector<char> keeps(mesh.normals.size(), 0);
  for (int f = 0; f < mesh.numFacets(); ++f)
    for (int i = 0; i < nodes; ++i) {
      const auto node = std::size_t(mesh.nodesOf(f)[i]);
      const auto& ends = mesh.endNormals[std::size_t(f)];
      const Direction n = i < mesh.dim ? ends[std::size_t(i)] : middleOf(ends, mesh.dim, i - mesh.dim);
      const Direction change = combine(1.0, n, -1.0, value[node]);
      if (isZero(n) || (!isZero(value[node]) && dotProduct(change, change) > straightOn * straightOn))
        keeps[node] = 1;
      value[node] = n;
    }
  for (std::size_t node = 0; node < value.size(); ++node)
    if (!keeps[node])
      mesh.normals[node] = value[node];
}

void turnNormals(InterfaceMesh& mesh, const Mesh& dirichletMesh, double cornerAngle)
{
  if (mesh.dim == 2)
    TurningSide(mesh, dirichletMesh).turn(cornerAngle);
  else
    mesh.endNormals = onTriangles(mesh, cornerAngle);
  if (!mesh.endNormals.empty())
    setNodeNormals(mesh);
}

void splitCorners(InterfaceMesh& mesh, const Mesh& dirichletMesh, double cornerAngle, const std::vector<char>& maySplit)
{
  TurningSide side(mesh, dirichletMesh);
  for (const int corner : cornerAngle > 0.0 ? side.corners(cornerAngle) : std::vector<int>())
    if (maySplit[std::size_t(corner)])
      side.split(corner);
}

InterfaceMesh sideAlone(const Mesh& mesh, const std::vector<Facet>& facets, double cornerAngle)
{
  InterfaceMesh side;
  side.dim = mesh.dim;
  side.order = 1;
  addSideFacets(side, mesh, makeNodeMap(mesh, 1), facets);
  for (const int node : side.sides[0].nodes)
    side.points.insert(side.points.end(), mesh.point(node), mesh.point(node) + mesh.dim);
  turnNormals(side, mesh, cornerAngle);
  return side;
}

bool inheritNormals(InterfaceMesh& mesh, const InterfaceMesh& earlier)
{
  const FacetTree tree(earlier);
  const auto corners = [](const InterfaceMesh& side, int facet) {
    std::array<const double*, 3> points{};
    for (int i = 0; i < side.dim; ++i)
      points[std::size_t(i)] = side.point(side.nodesOf(facet)[i]);
    return points;
  };
  std::vector<VertexNormals> normals(std::size_t(mesh.numFacets()));
  for (int f = 0; f < mesh.numFacets(); ++f) {
    const auto own = corners(mesh, f);
    double middle[3] = {};
    for (int i = 0; i < mesh.dim; ++i)
      for (int k = 0; k < mesh.dim; ++k)
        middle[k] += own[std::size_t(i)][k] / mesh.dim;
    const int parent = tree.nearest(middle).facet;
    const auto theirs = corners(earlier, parent);
    const VertexNormals ends = earlier.endNormals.empty() ? VertexNormals{} : earlier.endNormals[std::size_t(parent)];
    const double sign = dotProduct(ends[0], mesh.facetNormals[std::size_t(f)]) < 0.0 ? -1.0 : 1.0; // of the other body
    for (std::size_t i = 0; i < std::size_t(mesh.dim); ++i) {
      const auto place = mesh.dim == 2 ? placeOn(theirs[0], theirs[1], own[i]) : placeOn(theirs, own[i]);
      if (!place)
        return false;
      for (std::size_t a = 0; a < std::size_t(mesh.dim); ++a)
        normals[std::size_t(f)][i] = combine(1.0, normals[std::size_t(f)][i], sign * (*place)[a], ends[a]);
    }
  }
  setMeanNormals(mesh);
  if (earlier.endNormals.empty()) {
    mesh.endNormals.clear();
  } else {
    mesh.endNormals = std::move(normals);
    setNodeNormals(mesh);
  }
  return true;
}

} // namespace ndframe

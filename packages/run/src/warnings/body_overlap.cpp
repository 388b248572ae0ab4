#include "body_overlap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{
namespace
{

using Point = std::array<double, 3>;

/// Distances of a point from the boundary below this part of a cell's height are none.
constexpr double onBoundary = 1e-5;
/// Facets whose normals are opposite up to this cosine touch each other.
constexpr double opposite = -0.99;

struct Box
{
  Point lower{std::numeric_limits<double>::max(), std::numeric_limits<double>::max(), 0.0};
  Point upper{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest(), 0.0};
  void add(const double* x, int dim)
  {
    for (std::size_t k = 0; k < std::size_t(dim); ++k) {
      lower[k] = std::min(lower[k], x[k]);
      upper[k] = std::max(upper[k], x[k]);
    }
  }
  bool meets(const Box& other, int dim, double reach) const
  {
    for (std::size_t k = 0; k < std::size_t(dim); ++k)
      if (lower[k] > other.upper[k] + reach || other.lower[k] > upper[k] + reach)
        return false;
    return true;
  }
};

Box emptyBox(int dim)
{
  Box box;
  if (dim == 3) {
    box.lower[2] = std::numeric_limits<double>::max();
    box.upper[2] = std::numeric_limits<double>::lowest();
  }
  return box;
}

Box boxOfCell(const Mesh& mesh, int cell)
{
  Box box = emptyBox(mesh.dim);
  for (int v = 0; v <= mesh.dim; ++v)
    box.add(mesh.point(mesh.cell(cell)[v]), mesh.dim);
  return box;
}

Box boxOfMesh(const Mesh& mesh)
{
  Box box = emptyBox(mesh.dim);
  for (int p = 0; p < mesh.numPoints(); ++p)
    box.add(mesh.point(p), mesh.dim);
  return box;
}

/// Cells in a tree of boxes; found are those whose box holds a point.
class CellTree
{
public:
  CellTree(const Mesh& mesh, std::vector<int> cells) : mesh_(mesh), cells_(std::move(cells))
  {
    if (!cells_.empty())
      build(0, int(cells_.size()));
  }

  template <class Visit>
  void visit(const double* x, double reach, const Visit& visitCell) const
  {
    Box at = emptyBox(mesh_.dim);
    at.add(x, mesh_.dim);
    if (!nodes_.empty())
      descend(0, at, reach, visitCell);
  }

private:
  struct Node
  {
    Box box;
    int begin, end, right; ///< right: 0 in a leaf
  };

  int build(int begin, int end)
  {
    const int number = int(nodes_.size());
    Box box = emptyBox(mesh_.dim);
    for (int i = begin; i < end; ++i)
      for (int v = 0; v <= mesh_.dim; ++v)
        box.add(mesh_.point(mesh_.cell(cells_[std::size_t(i)])[v]), mesh_.dim);
    nodes_.push_back({box, begin, end, 0});
    if (end - begin <= 4)
      return number;
    std::size_t axis = 0;
    for (std::size_t k = 1; k < std::size_t(mesh_.dim); ++k)
      axis = box.upper[k] - box.lower[k] > box.upper[axis] - box.lower[axis] ? k : axis;
    const int middle = (begin + end) / 2;
    std::nth_element(cells_.begin() + begin, cells_.begin() + middle, cells_.begin() + end,
                     [&](int a, int b) { return cellCentre(mesh_, a)[axis] < cellCentre(mesh_, b)[axis]; });
    build(begin, middle);
    nodes_[std::size_t(number)].right = build(middle, end);
    return number;
  }

  template <class Visit>
  void descend(int number, const Box& at, double reach, const Visit& visitCell) const
  {
    const Node& node = nodes_[std::size_t(number)];
    if (!node.box.meets(at, mesh_.dim, reach))
      return;
    if (node.right > 0) {
      descend(number + 1, at, reach, visitCell);
      descend(node.right, at, reach, visitCell);
      return;
    }
    for (int i = node.begin; i < node.end; ++i)
      visitCell(cells_[std::size_t(i)]);
  }

  const Mesh& mesh_;
  std::vector<int> cells_;
  std::vector<Node> nodes_;
};

/// Distances of a point from the planes of a cell's facets, positive inside, and their outward normals.
struct FacetDistances
{
  std::array<double, 4> distance{};
  std::array<Point, 4> normal{};
  double height = 0.0; ///< the smallest of the cell
};

FacetDistances distancesFrom(const Mesh& mesh, int cell, const double* x)
{
  FacetDistances result;
  result.height = std::numeric_limits<double>::max();
  for (int local = 0; local <= mesh.dim; ++local) {
    const auto f = std::size_t(local);
    const double measure = facetNormal(mesh, {cell, local}, result.normal[f].data());
    result.height = std::min(result.height, mesh.dim * std::abs(cellMeasure(mesh, cell)) / measure);
    const double* on = mesh.point(mesh.cell(cell)[local == 0 ? 1 : 0]);
    for (std::size_t k = 0; k < std::size_t(mesh.dim); ++k)
      result.distance[f] -= result.normal[f][k] * (x[k] - on[k]);
  }
  return result;
}

void look(const BoundaryView& body, const std::set<std::pair<int, int>>& boundary, int cell, const BoundaryPoint& point,
          Standing& standing)
{
  const auto& mesh = *body.mesh;
  const auto facets = distancesFrom(mesh, cell, point.x.data());
  const double nothing = onBoundary * facets.height;
  const auto last = facets.distance.begin() + mesh.dim + 1;
  if (*std::min_element(facets.distance.begin(), last) < -nothing)
    return;
  standing.inside = true;
  standing.depth = std::min(standing.depth, facets.height);
  for (int local = 0; local <= mesh.dim; ++local) {
    if (boundary.count({cell, local}) == 0)
      continue;
    const auto f = std::size_t(local);
    standing.depth = std::min(standing.depth, facets.distance[f] < nothing ? 0.0 : facets.distance[f]);
    const auto& n = facets.normal[f];
    if (facets.distance[f] < nothing && body.paired.count({cell, local}) == 0 &&
        n[0] * point.normal[0] + n[1] * point.normal[1] + n[2] * point.normal[2] < opposite)
      standing.touches = true;
  }
}

/// Inner points of a facet, barycentric: a third of it is not missed.
std::vector<Point> pointsOf(const Mesh& mesh, Facet facet)
{
  static const QuadratureRule onEdge = simplexRule(1, 5), onFace = simplexRule(2, 2);
  const QuadratureRule& rule = mesh.dim == 2 ? onEdge : onFace;
  int vertices[3];
  facetVertices(mesh, facet, vertices);
  std::vector<Point> points(std::size_t(rule.size()));
  for (int q = 0; q < rule.size(); ++q)
    for (int v = 0; v < mesh.dim; ++v)
      for (std::size_t k = 0; k < std::size_t(mesh.dim); ++k)
        points[std::size_t(q)][k] += rule.point(q)[v] * mesh.point(vertices[v])[k];
  return points;
}

} // namespace

double reachOf(double diameter, double other)
{
  return onBoundary * std::max(diameter, other);
}

std::vector<BoundaryPoint> pointsOf(const BoundaryView& body)
{
  std::vector<BoundaryPoint> points;
  for (const Facet facet : body.facets) {
    if (body.paired.count({facet.cell, facet.local}) > 0)
      continue;
    Point normal{};
    facetNormal(*body.mesh, facet, normal.data());
    for (const Point& point : pointsOf(*body.mesh, facet))
      points.push_back({point, normal});
  }
  return points;
}

std::vector<Standing> standingsOf(const std::vector<BoundaryPoint>& points, const BoundaryView& body, double reach)
{
  Box all = emptyBox(body.mesh->dim);
  for (const BoundaryPoint& point : points)
    all.add(point.x.data(), body.mesh->dim);
  std::vector<int> near;
  for (int c = 0; c < body.lookedAt(); ++c)
    if (boxOfCell(*body.mesh, c).meets(all, body.mesh->dim, reach))
      near.push_back(c);
  std::set<std::pair<int, int>> boundary;
  for (const Facet facet : body.facets)
    boundary.insert({facet.cell, facet.local});
  const CellTree tree(*body.mesh, std::move(near));
  std::vector<Standing> standings(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    tree.visit(points[i].x.data(), reach, [&](int cell) { look(body, boundary, cell, points[i], standings[i]); });
  return standings;
}

Encounter encounterAt(const std::vector<BoundaryPoint>& points, const std::vector<Standing>& standings)
{
  Encounter result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (standings[i].touches && !result.touching)
      result.touching = points[i].x;
    if (standings[i].inside && standings[i].depth > result.depth) {
      result.depth = standings[i].depth;
      result.deepest = points[i].x;
    }
  }
  return result;
}

Encounter deeperOf(Encounter one, const Encounter& other)
{
  if (!one.touching)
    one.touching = other.touching;
  if (other.depth > one.depth) {
    one.depth = other.depth;
    one.deepest = other.deepest;
  }
  return one;
}

Encounter encounter(const BoundaryView& first, const BoundaryView& second)
{
  const double reach = reachOf(diameter(*first.mesh), diameter(*second.mesh));
  if (!boxOfMesh(*first.mesh).meets(boxOfMesh(*second.mesh), first.mesh->dim, reach))
    return {};
  const std::vector<BoundaryPoint> points = pointsOf(first);
  return encounterAt(points, standingsOf(points, second, reach));
}

std::vector<std::pair<int, int>> nearPairs(const std::vector<const Mesh*>& meshes)
{
  std::vector<Box> boxes;
  double reach = 0.0;
  for (const Mesh* mesh : meshes) {
    boxes.push_back(boxOfMesh(*mesh));
    reach = std::max(reach, onBoundary * diameter(*mesh));
  }
  std::vector<int> byLeft(meshes.size());
  std::iota(byLeft.begin(), byLeft.end(), 0);
  const auto box = [&](int mesh) -> const Box& { return boxes[std::size_t(mesh)]; };
  std::sort(byLeft.begin(), byLeft.end(), [&](int a, int b) { return box(a).lower[0] < box(b).lower[0]; });
  std::vector<std::pair<int, int>> pairs;
  for (auto first = byLeft.begin(); first != byLeft.end(); ++first)
    for (auto second = first + 1; second != byLeft.end(); ++second) {
      if (box(*second).lower[0] > box(*first).upper[0] + reach)
        break;
      if (box(*first).meets(box(*second), meshes.front()->dim, reach))
        pairs.emplace_back(std::min(*first, *second), std::max(*first, *second));
    }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

Encounter encounterOf(const BoundaryView& a, const BoundaryView& b)
{
  return deeperOf(encounter(a, b), encounter(b, a));
}

} // namespace ndframe

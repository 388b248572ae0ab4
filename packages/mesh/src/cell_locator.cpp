#include "ndframe/mesh/cell_locator.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

constexpr int cellsOfLeaf = 4;

using Point = std::array<double, 3>;

/// Where the point of a segment lies that is nearest to x: 0 at a, 1 at b.
double nearestOnSegment(const double* a, const double* b, const Point& x)
{
  const double d[2] = {b[0] - a[0], b[1] - a[1]};
  const double along = ((x[0] - a[0]) * d[0] + (x[1] - a[1]) * d[1]) / (d[0] * d[0] + d[1] * d[1]);
  return std::clamp(along, 0.0, 1.0);
}

/// Twice the signed area of (a, b, x).
double turn(const double* a, const double* b, const Point& x)
{
  return (b[0] - a[0]) * (x[1] - a[1]) - (b[1] - a[1]) * (x[0] - a[0]);
}

Point minus(const Point& a, const Point& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double dot(const Point& a, const Point& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Point cross(const Point& a, const Point& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A tetrahedron, a face, an edge or a vertex of it, and where in the tetrahedron its vertices are.
struct Simplex
{
  std::array<Point, 4> vertices{};
  std::array<std::size_t, 4> places{0, 1, 2, 3}; ///< of the tetrahedron's vertices
  std::size_t size = 4;                          ///< number of vertices

  Simplex without(std::size_t vertex) const
  {
    Simplex facet{{}, {}, 0};
    for (std::size_t v = 0; v < size; ++v)
      if (v != vertex) {
        facet.vertices[facet.size] = vertices[v];
        facet.places[facet.size++] = places[v];
      }
    return facet;
  }

  /// Barycentric coordinates of the point of its space, plane or line that is nearest to x.
  std::array<double, 4> coordinates(const Point& x) const
  {
    if (size == 1)
      return {1.0};
    const Point d = minus(x, vertices[0]), a = minus(vertices[1], vertices[0]);
    if (size == 2)
      return withFirst({dot(d, a) / dot(a, a)});
    const Point b = minus(vertices[2], vertices[0]), normal = cross(a, b);
    if (size == 3)
      return withFirst(
          {dot(cross(d, b), normal) / dot(normal, normal), dot(cross(a, d), normal) / dot(normal, normal)});
    const Point c = minus(vertices[3], vertices[0]);
    const double volume = dot(normal, c);
    return withFirst({dot(cross(b, c), d) / volume, dot(cross(c, a), d) / volume, dot(normal, d) / volume});
  }

private:
  static std::array<double, 4> withFirst(const Point& others)
  {
    return {1.0 - others[0] - others[1] - others[2], others[0], others[1], others[2]};
  }
};

/// Takes the simplex' point that is nearest to x where it is nearer than what was found so far. Where x lies on the
/// outer side of facets, that point is on one of these.
void compareWith(const Simplex& simplex, const Point& x, int cell, CellLocator::Place& nearest)
{
  const std::array<double, 4> lambda = simplex.coordinates(x);
  bool isOutside = false;
  for (std::size_t v = 0; v < simplex.size; ++v)
    if (!(lambda[v] >= 0.0)) {
      isOutside = true;
      compareWith(simplex.without(v), x, cell, nearest);
    }
  if (isOutside)
    return;
  Point d = x;
  for (std::size_t v = 0; v < simplex.size; ++v)
    for (std::size_t k = 0; k < 3; ++k)
      d[k] -= lambda[v] * simplex.vertices[v][k];
  const double squared = simplex.size == 4 ? 0.0 : dot(d, d);
  if (!(squared < nearest.squaredDistance))
    return;
  nearest = {squared, cell, {}};
  for (std::size_t v = 0; v < simplex.size; ++v)
    nearest.weights[simplex.places[v]] = lambda[v];
}

} // namespace

CellLocator::CellLocator(const Mesh& mesh) : mesh_(mesh), order_(std::size_t(mesh.numCells()))
{
  NDFRAME_ASSERT(mesh.numCells() > 0, "a mesh without cells has nothing to find");
  std::iota(order_.begin(), order_.end(), 0);
  build(0, int(order_.size()));
}

CellLocator::Box CellLocator::boxOf(int begin, int end) const
{
  const double infinity = std::numeric_limits<double>::infinity();
  Box box{};
  for (std::size_t k = 0; k < std::size_t(mesh_.dim); ++k) {
    box.lower[k] = infinity;
    box.upper[k] = -infinity;
  }
  for (int i = begin; i < end; ++i)
    for (int v = 0; v <= mesh_.dim; ++v)
      for (std::size_t k = 0; k < std::size_t(mesh_.dim); ++k) {
        const double x = mesh_.point(mesh_.cell(order_[std::size_t(i)])[v])[k];
        box.lower[k] = std::min(box.lower[k], x);
        box.upper[k] = std::max(box.upper[k], x);
      }
  return box;
}

/// Halves the cells at the median of their centres, across the longest side of their box.
int CellLocator::build(int begin, int end)
{
  const int node = int(nodes_.size());
  nodes_.push_back({boxOf(begin, end), begin, end, 0});
  if (end - begin <= cellsOfLeaf)
    return node;
  const Box box = nodes_.back().box;
  const auto length = [&box](std::size_t d) { return box.upper[d] - box.lower[d]; };
  std::size_t k = 0;
  for (std::size_t d = 1; d < 3; ++d)
    if (length(k) < length(d))
      k = d;
  const auto before = [&](int a, int b) { return cellCentre(mesh_, a)[k] < cellCentre(mesh_, b)[k]; };
  const int middle = (begin + end) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end, before);
  build(begin, middle);
  const int right = build(middle, end);
  nodes_[std::size_t(node)].right = right;
  return node;
}

CellLocator::Place CellLocator::find(const std::array<double, 3>& point) const
{
  Place nearest;
  search(0, point, nearest);
  return nearest;
}

double CellLocator::squaredDistance(const Box& box, const std::array<double, 3>& point) const
{
  double squared = 0.0;
  for (std::size_t k = 0; k < std::size_t(mesh_.dim); ++k) {
    const double outside = std::max({box.lower[k] - point[k], 0.0, point[k] - box.upper[k]});
    squared += outside * outside;
  }
  return squared;
}

void CellLocator::search(int node, const std::array<double, 3>& point, Place& nearest) const
{
  const Node& here = nodes_[std::size_t(node)];
  if (here.right == 0) {
    for (int i = here.begin; i < here.end; ++i)
      compare(order_[std::size_t(i)], point, nearest);
    return;
  }
  std::array<std::pair<double, int>, 2> children;
  for (std::size_t c = 0; c < 2; ++c) {
    const int child = c == 0 ? node + 1 : here.right;
    children[c] = {squaredDistance(nodes_[std::size_t(child)].box, point), child};
  }
  std::sort(children.begin(), children.end());
  for (const auto& [squared, child] : children)
    if (squared < nearest.squaredDistance)
      search(child, point, nearest);
}

void CellLocator::compare(int cell, const std::array<double, 3>& point, Place& nearest) const
{
  if (mesh_.dim == 2)
    return compareInPlane(cell, point, nearest);
  Simplex simplex;
  for (std::size_t v = 0; v < 4; ++v)
    std::copy_n(mesh_.point(mesh_.cell(cell)[v]), 3, simplex.vertices[v].begin());
  compareWith(simplex, point, cell, nearest);
}

void CellLocator::compareInPlane(int cell, const std::array<double, 3>& point, Place& nearest) const
{
  const int* v = mesh_.cell(cell);
  const double* x[3] = {mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2])};
  const double turns[3] = {turn(x[1], x[2], point), turn(x[2], x[0], point), turn(x[0], x[1], point)};
  if (turns[0] >= 0.0 && turns[1] >= 0.0 && turns[2] >= 0.0) {
    const double sum = turns[0] + turns[1] + turns[2];
    nearest = {0.0, cell, {turns[0] / sum, turns[1] / sum, turns[2] / sum}};
    return;
  }
  for (int k = 0; k < 3; ++k) {
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    if (turns[k] >= 0.0)
      continue;
    const double t = nearestOnSegment(x[a], x[b], point);
    const double dx = x[a][0] + t * (x[b][0] - x[a][0]) - point[0], dy = x[a][1] + t * (x[b][1] - x[a][1]) - point[1];
    const double squared = dx * dx + dy * dy;
    if (squared < nearest.squaredDistance) {
      nearest = {squared, cell, {}};
      nearest.weights[std::size_t(a)] = 1.0 - t;
      nearest.weights[std::size_t(b)] = t;
    }
  }
}

} // namespace ndframe

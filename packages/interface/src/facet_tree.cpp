#include "facet_tree.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace ndframe
{
namespace
{

using Point = std::array<double, 3>;

Point difference(const Point& a, const Point& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// The point of the segment ab nearest to x, as its share of b.
double nearestOnSegment(const Point& a, const Point& b, const Point& x)
{
  const Point along = difference(b, a);
  return std::clamp(dotProduct(difference(x, a), along) / dotProduct(along, along), 0.0, 1.0);
}

/// Barycentric coordinates of the foot of x in the plane of a triangle.
Point footOnPlane(const std::array<Point, 3>& corners, const Point& x)
{
  const Point u = difference(corners[1], corners[0]), v = difference(corners[2], corners[0]);
  const Point w = difference(x, corners[0]);
  const double uu = dotProduct(u, u), uv = dotProduct(u, v), vv = dotProduct(v, v);
  const double wu = dotProduct(w, u), wv = dotProduct(w, v), det = uu * vv - uv * uv;
  const double s = (vv * wu - uv * wv) / det, t = (uu * wv - uv * wu) / det;
  return {1.0 - s - t, s, t};
}

} // namespace

FacetTree::FacetTree(const InterfaceMesh& mesh) : mesh_(mesh)
{
  NDFRAME_ASSERT(mesh.numFacets() > 0, "an interface without facets has no nearest one");
  std::vector<int> facets(std::size_t(mesh.numFacets()));
  std::iota(facets.begin(), facets.end(), 0);
  build(facets, 0, mesh.numFacets());
}

FacetTree::Point FacetTree::vertex(int facet, int local) const
{
  Point x{};
  std::copy_n(mesh_.point(mesh_.nodesOf(facet)[local]), mesh_.dim, x.begin());
  return x;
}

FacetTree::Point FacetTree::centre(int facet) const
{
  Point x{};
  for (int a = 0; a < mesh_.dim; ++a)
    for (std::size_t k = 0; k < 3; ++k)
      x[k] += vertex(facet, a)[k] / mesh_.dim;
  return x;
}

int FacetTree::build(std::vector<int>& facets, int first, int last)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box box{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  for (int i = first; i < last; ++i)
    for (int a = 0; a < mesh_.dim; ++a) {
      const Point x = vertex(facets[std::size_t(i)], a);
      for (std::size_t k = 0; k < 3; ++k) {
        box.lower[k] = std::min(box.lower[k], x[k]);
        box.upper[k] = std::max(box.upper[k], x[k]);
      }
    }
  const auto number = boxes_.size();
  boxes_.push_back(box);
  if (last - first == 1) {
    boxes_[number].facet = facets[std::size_t(first)];
    return int(number);
  }
  const Point size = difference(box.upper, box.lower);
  const auto longest = std::size_t(std::max_element(size.begin(), size.end()) - size.begin());
  const int middle = (first + last) / 2;
  std::nth_element(facets.begin() + first, facets.begin() + middle, facets.begin() + last,
                   [&](int f, int g) { return centre(f)[longest] < centre(g)[longest]; });
  build(facets, first, middle);
  const int right = build(facets, middle, last);
  boxes_[number].right = right;
  return int(number);
}

double FacetTree::squaredDistance(const Box& box, const Point& x)
{
  double squared = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double outside = std::max({box.lower[k] - x[k], x[k] - box.upper[k], 0.0});
    squared += outside * outside;
  }
  return squared;
}

FacetTree::Place FacetTree::nearestOn(int facet, const Point& x) const
{
  std::array<Point, 3> corners{};
  for (int a = 0; a < mesh_.dim; ++a)
    corners[std::size_t(a)] = vertex(facet, a);
  const auto placeAt = [&](const Point& lambda) {
    Point offset = x;
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t k = 0; k < 3; ++k)
        offset[k] -= lambda[a] * corners[a][k];
    return Place{facet, lambda, dotProduct(offset, offset)};
  };
  if (mesh_.dim == 3)
    if (const Point foot = footOnPlane(corners, x); *std::min_element(foot.begin(), foot.end()) >= 0.0)
      return placeAt(foot);
  Place best;
  const std::size_t edges = mesh_.dim == 2 ? 1 : 3;
  for (std::size_t a = 0; a < edges; ++a) {
    const std::size_t b = (a + 1) % 3;
    Point lambda{};
    lambda[b] = nearestOnSegment(corners[a], corners[b], x);
    lambda[a] = 1.0 - lambda[b];
    const Place place = placeAt(lambda);
    if (best.facet < 0 || place.squaredDistance < best.squaredDistance)
      best = place;
  }
  return best;
}

void FacetTree::search(int number, const Point& x, Place& best) const
{
  const Box& box = boxes_[std::size_t(number)];
  if (best.facet >= 0 && squaredDistance(box, x) >= best.squaredDistance)
    return;
  if (box.facet >= 0) {
    const Place place = nearestOn(box.facet, x);
    if (best.facet < 0 || place.squaredDistance < best.squaredDistance)
      best = place;
    return;
  }
  int near = number + 1, far = box.right;
  if (squaredDistance(boxes_[std::size_t(far)], x) < squaredDistance(boxes_[std::size_t(near)], x))
    std::swap(near, far);
  search(near, x, best);
  search(far, x, best);
}

FacetTree::Place FacetTree::nearest(const double* point) const
{
  Point x{};
  std::copy_n(point, mesh_.dim, x.begin());
  Place best;
  search(0, x, best);
  return best;
}

} // namespace ndframe

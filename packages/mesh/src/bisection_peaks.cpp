#include "bisection_peaks.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "ndframe/mesh/shape.hpp"

namespace ndframe
{

namespace
{

constexpr double equalLengths = 1e-8;
constexpr int undecided = -1;

/// Of the distance.
double square(const double* p, const double* q)
{
  return (p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]);
}

/// Which edges of a triangle are longest, and the middles of all three, by the opposite vertex.
struct Shape
{
  std::array<bool, 3> isLongest;
  std::array<std::array<double, 2>, 3> middles;
};

Shape shapeOf(const Corners& corners)
{
  Shape shape{};
  std::array<double, 3> squares{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double* a = corners[(k + 1) % 3];
    const double* b = corners[(k + 2) % 3];
    squares[k] = square(a, b);
    shape.middles[k] = {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])};
  }
  const double longest = *std::max_element(squares.begin(), squares.end());
  for (std::size_t k = 0; k < 3; ++k)
    shape.isLongest[k] = squares[k] >= (1.0 - 2.0 * equalLengths) * longest;
  return shape;
}

/// An edge as its one or two triangles see it.
struct SharedEdge
{
  std::array<double, 2> middle{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  std::array<int, 2> slots{}; ///< 3 * triangle + local edge
  int numTriangles = 0;
  bool isLongest = true; ///< in all of them
};

std::vector<Shape> shapesOf(const std::vector<Mesh>& meshes)
{
  std::vector<Shape> shapes;
  for (const Mesh& mesh : meshes)
    for (int c = 0; c < mesh.numCells(); ++c) {
      const int* v = mesh.cell(c);
      shapes.push_back(shapeOf({mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2])}));
    }
  return shapes;
}

std::vector<SharedEdge> shareEdges(const std::vector<Shape>& shapes, const std::vector<std::array<int, 3>>& edges,
                                   int numEdges)
{
  std::vector<SharedEdge> shared{std::size_t(numEdges)};
  for (std::size_t t = 0; t < edges.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      SharedEdge& edge = shared[std::size_t(edges[t][k])];
      edge.middle = std::min(edge.middle, shapes[t].middles[k]); // twins differ by round-off: not by who comes first
      edge.slots[std::size_t(edge.numTriangles++)] = int(3 * t + k);
      edge.isLongest = edge.isLongest && shapes[t].isLongest[k];
    }
  return shared;
}

/// Edges that are longest for all their triangles, from left to right.
std::vector<const SharedEdge*> agreedEdges(const std::vector<SharedEdge>& shared)
{
  std::vector<const SharedEdge*> agreed;
  for (const SharedEdge& edge : shared)
    if (edge.isLongest)
      agreed.push_back(&edge);
  std::sort(agreed.begin(), agreed.end(),
            [](const SharedEdge* a, const SharedEdge* b) { return a->middle < b->middle; });
  return agreed;
}

/// The local number of the rightmost among a triangle's longest edges.
int rightmostLongest(const Shape& shape)
{
  const auto key = [&](std::size_t k) { return std::pair(shape.isLongest[k], shape.middles[k]); };
  std::size_t best = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (key(best) < key(k))
      best = k;
  return int(best);
}

} // namespace

std::vector<int> firstPeaks(const std::vector<Mesh>& meshes, const std::vector<std::array<int, 3>>& edges, int numEdges)
{
  const std::vector<Shape> shapes = shapesOf(meshes);
  const std::vector<SharedEdge> shared = shareEdges(shapes, edges, numEdges);
  std::vector<int> peaks(edges.size(), undecided);
  for (const SharedEdge* edge : agreedEdges(shared)) {
    const auto end = edge->slots.begin() + edge->numTriangles;
    const auto isFree = [&](int slot) { return peaks[std::size_t(slot / 3)] == undecided; };
    if (std::all_of(edge->slots.begin(), end, isFree))
      for (auto slot = edge->slots.begin(); slot != end; ++slot)
        peaks[std::size_t(*slot / 3)] = *slot % 3;
  }
  for (std::size_t t = 0; t < peaks.size(); ++t)
    if (peaks[t] == undecided) {
      Shape shape = shapes[t];
      for (std::size_t k = 0; k < 3; ++k)
        shape.middles[k] = shared[std::size_t(edges[t][k])].middle; // the same for twins
      peaks[t] = rightmostLongest(shape);
    }
  return peaks;
}

int longestPeak(const Corners& corners)
{
  return rightmostLongest(shapeOf(corners));
}

double worstDescendant(const Corners& corners, int peak)
{
  const auto k = std::size_t(peak);
  const double *x = corners[k], *y = corners[(k + 1) % 3], *z = corners[(k + 2) % 3];
  const double a = square(x, z), b = square(x, y), c = square(y, z);
  const double worst = std::max({a + b + c, 3 * a + b, a + 3 * b, 3 * (a + b) - c});
  return triangleShape(x, y, z) * (a + b + c) / worst;
}

int mendedPeak(const Corners& corners, int peak)
{
  const int longest = longestPeak(corners);
  return worstDescendant(corners, longest) > clearly * worstDescendant(corners, peak) ? longest : peak;
}

} // namespace ndframe

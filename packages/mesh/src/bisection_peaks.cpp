#include "bisection_peaks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ndframe
{

namespace
{

constexpr double equalLengths = 1e-8;
constexpr int undecided = -1;

/// Which edges of a triangle are longest, and the middles of all three, by the opposite vertex.
struct Shape
{
  std::array<bool, 3> isLongest;
  std::array<std::array<double, 2>, 3> middles;
};

Shape shapeOf(const Mesh& mesh, int cell)
{
  double points[6];
  cellPoints(mesh, cell, points);
  Shape shape{};
  std::array<double, 3> lengths{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double* a = points + 2 * ((k + 1) % 3);
    const double* b = points + 2 * ((k + 2) % 3);
    lengths[k] = std::hypot(b[0] - a[0], b[1] - a[1]);
    shape.middles[k] = {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])};
  }
  const double longest = *std::max_element(lengths.begin(), lengths.end());
  for (std::size_t k = 0; k < 3; ++k)
    shape.isLongest[k] = lengths[k] >= (1.0 - equalLengths) * longest;
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
    for (int c = 0; c < mesh.numCells(); ++c)
      shapes.push_back(shapeOf(mesh, c));
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
int rightmostLongest(const Shape& shape, const std::array<int, 3>& edges, const std::vector<SharedEdge>& shared)
{
  const auto key = [&](std::size_t k) { return std::pair(shape.isLongest[k], shared[std::size_t(edges[k])].middle); };
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
    if (peaks[t] == undecided)
      peaks[t] = rightmostLongest(shapes[t], edges[t], shared);
  return peaks;
}

} // namespace ndframe

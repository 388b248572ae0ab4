#include <algorithm>
#include <tuple>

#include "bisection_peaks.hpp"
#include "ndframe/mesh/bisection.hpp"
#include "ndframe/mesh/shape.hpp"

namespace ndframe
{

namespace
{

double shapeOf(const Corners& corners)
{
  return triangleShape(corners[0], corners[1], corners[2]);
}

} // namespace

/// The best first, equally good ones from left to right: numbers do not decide which of two that exclude each other is
/// made. (In single precision, for equally good ones differ by round-off.)
void Bisection::swapEdges()
{
  while (!unchecked_.empty()) {
    std::vector<std::tuple<float, double, double, int>> swaps; // gain, middle of the edge
    for (const int edge : unchecked_)
      if (const double gain = gainOfSwap(edge); gain > clearly) {
        const int slot = edges_[std::size_t(edge)].slots[0];
        const Corners corners = cornersOf(triangles_[std::size_t(slot / 3)], meshOf(slot / 3));
        const double *a = corners[std::size_t((slot + 1) % 3)], *b = corners[std::size_t((slot + 2) % 3)];
        swaps.emplace_back(-float(gain), 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), edge);
      }
    unchecked_.clear();
    std::sort(swaps.begin(), swaps.end());
    for (const auto& swap : swaps)
      if (gainOfSwap(std::get<3>(swap)) > clearly) // still, after those before it
        swapEdge(std::get<3>(swap));
  }
}

/// How many times better the worse of the two shapes becomes; 0 if there is nothing to swap or a worse one could come
/// of it.
double Bisection::gainOfSwap(int number) const
{
  const Edge& edge = edges_[std::size_t(number)];
  if (edge.child >= 0 || edge.slots[0] < 0 || edge.slots[1] < 0)
    return 0.0;
  const int mesh = meshOf(edge.slots[0] / 3);
  if (mesh != meshOf(edge.slots[1] / 3))
    return 0.0;
  const Triangle &one = triangles_[std::size_t(edge.slots[0] / 3)], &two = triangles_[std::size_t(edge.slots[1] / 3)];
  if (!meshes_[std::size_t(mesh)].groups.sameKind(one.parent, two.parent))
    return 0.0;
  const std::array<Triangle, 2> after = swapped(number);
  const Corners now[2] = {cornersOf(one, mesh), cornersOf(two, mesh)};
  const Corners then[2] = {cornersOf(after[0], mesh), cornersOf(after[1], mesh)};
  const double worst = std::min(worstDescendant(now[0], one.peak), worstDescendant(now[1], two.peak));
  if (std::min(worstDescendant(then[0], after[0].peak), worstDescendant(then[1], after[1].peak)) < (1.0 - 1e-8) * worst)
    return 0.0;
  return std::min(shapeOf(then[0]), shapeOf(then[1])) / std::min(shapeOf(now[0]), shapeOf(now[1]));
}

/// Both triangles of an inner edge after it went to the other diagonal of their quadrilateral; each in the place of the
/// one from which it has the peak and the vertex that comes next.
std::array<Bisection::Triangle, 2> Bisection::swapped(int edge) const
{
  const std::array<int, 2> slots = edges_[std::size_t(edge)].slots;
  std::array<Triangle, 2> after{};
  for (std::size_t i = 0; i < 2; ++i) {
    const Triangle &one = triangles_[std::size_t(slots[i] / 3)], &other = triangles_[std::size_t(slots[1 - i] / 3)];
    const auto k = std::size_t(slots[i] % 3), l = std::size_t(slots[1 - i] % 3);
    after[i] = one;
    after[i].vertices = {one.vertices[k], one.vertices[(k + 1) % 3], other.vertices[l]};
    after[i].edges = {other.edges[(l + 1) % 3], 2 * edge + int(i), one.edges[(k + 2) % 3]};
    after[i].peak = longestPeak(cornersOf(after[i], meshOf(slots[i] / 3)));
  }
  return after;
}

void Bisection::swapEdge(int edge)
{
  const std::array<Triangle, 2> after = swapped(edge);
  const std::array<int, 2> slots = edges_[std::size_t(edge)].slots;
  for (std::size_t i = 0; i < 2; ++i) {
    triangles_[std::size_t(slots[i] / 3)] = after[i];
    linkEdges(slots[i] / 3);
    unchecked_.insert(unchecked_.end(), {after[i].edges[0] / 2, after[i].edges[2] / 2});
  }
}

int Bisection::meshOf(int triangle) const
{
  return int(std::upper_bound(begin_.begin(), begin_.end(), triangle) - begin_.begin()) - 1;
}

} // namespace ndframe

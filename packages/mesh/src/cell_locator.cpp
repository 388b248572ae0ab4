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

/// Where the point of a segment lies that is nearest to x: 0 at a, 1 at b.
double nearestOnSegment(const double* a, const double* b, const std::array<double, 2>& x)
{
  const double d[2] = {b[0] - a[0], b[1] - a[1]};
  const double along = ((x[0] - a[0]) * d[0] + (x[1] - a[1]) * d[1]) / (d[0] * d[0] + d[1] * d[1]);
  return std::clamp(along, 0.0, 1.0);
}

/// Twice the signed area of (a, b, x).
double turn(const double* a, const double* b, const std::array<double, 2>& x)
{
  return (b[0] - a[0]) * (x[1] - a[1]) - (b[1] - a[1]) * (x[0] - a[0]);
}

} // namespace

CellLocator::CellLocator(const Mesh& mesh) : mesh_(mesh), order_(std::size_t(mesh.numCells()))
{
  NDFRAME_ASSERT(mesh.dim == 2 && mesh.numCells() > 0, "cells are searched in the plane");
  std::iota(order_.begin(), order_.end(), 0);
  build(0, int(order_.size()));
}

CellLocator::Box CellLocator::boxOf(int begin, int end) const
{
  const double infinity = std::numeric_limits<double>::infinity();
  Box box{{infinity, infinity}, {-infinity, -infinity}};
  for (int i = begin; i < end; ++i)
    for (int v = 0; v < 3; ++v)
      for (std::size_t k = 0; k < 2; ++k) {
        const double x = mesh_.point(mesh_.cell(order_[std::size_t(i)])[v])[k];
        box.lower[k] = std::min(box.lower[k], x);
        box.upper[k] = std::max(box.upper[k], x);
      }
  return box;
}

/// Halves the cells at the median of their centres, across the longer side of their box.
int CellLocator::build(int begin, int end)
{
  const int node = int(nodes_.size());
  nodes_.push_back({boxOf(begin, end), begin, end, 0});
  if (end - begin <= cellsOfLeaf)
    return node;
  const Box box = nodes_.back().box;
  const std::size_t k = box.upper[0] - box.lower[0] < box.upper[1] - box.lower[1] ? 1 : 0;
  const auto before = [&](int a, int b) { return cellCentre(mesh_, a)[k] < cellCentre(mesh_, b)[k]; };
  const int middle = (begin + end) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end, before);
  build(begin, middle);
  const int right = build(middle, end);
  nodes_[std::size_t(node)].right = right;
  return node;
}

CellLocator::Place CellLocator::find(const std::array<double, 2>& point) const
{
  Place nearest;
  search(0, point, nearest);
  return nearest;
}

double CellLocator::squaredDistance(const Box& box, const std::array<double, 2>& point)
{
  double squared = 0.0;
  for (std::size_t k = 0; k < 2; ++k) {
    const double outside = std::max({box.lower[k] - point[k], 0.0, point[k] - box.upper[k]});
    squared += outside * outside;
  }
  return squared;
}

void CellLocator::search(int node, const std::array<double, 2>& point, Place& nearest) const
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

void CellLocator::compare(int cell, const std::array<double, 2>& point, Place& nearest) const
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

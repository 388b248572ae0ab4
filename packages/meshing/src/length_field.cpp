#include "length_field.hpp"

#include <cmath>
#include <functional>
#include <queue>
#include <utility>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/mesh/vertex_cells.hpp"

namespace ndframe
{
namespace
{

double distanceOf(const Mesh& mesh, int v, int w)
{
  const double *a = mesh.point(v), *b = mesh.point(w);
  return mesh.dim == 2 ? std::hypot(b[0] - a[0], b[1] - a[1]) : std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
}

} // namespace

LengthField::LengthField(const Mesh& mesh, std::vector<double> lengths)
    : mesh_(mesh), cells_(mesh), lengths_(std::move(lengths))
{
  NDFRAME_ASSERT(lengths_.size() == std::size_t(mesh.numPoints()), "one length per vertex");
}

double LengthField::at(const std::array<double, 3>& point) const
{
  const CellLocator::Place place = cells_.find(point);
  double length = 0.0;
  for (std::size_t k = 0; k <= std::size_t(mesh_.dim); ++k)
    length += place.weights[k] * lengths_[std::size_t(mesh_.cell(place.cell)[k])];
  return length;
}

std::vector<double> withLimitedGrowth(const Mesh& mesh, std::vector<double> lengths, double slope)
{
  const VertexCells cells(mesh);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue; // the shortest length first: it is final
  for (int v = 0; v < mesh.numPoints(); ++v)
    queue.emplace(lengths[std::size_t(v)], v);
  while (!queue.empty()) {
    const auto [length, v] = queue.top();
    queue.pop();
    if (length > lengths[std::size_t(v)])
      continue;
    for (const int* cell = cells.begin(v); cell != cells.end(v); ++cell)
      for (int k = 0; k <= mesh.dim; ++k) {
        const int w = mesh.cell(*cell)[k];
        const double distance = distanceOf(mesh, v, w);
        if (length + slope * distance < lengths[std::size_t(w)])
          queue.emplace(lengths[std::size_t(w)] = length + slope * distance, w);
      }
  }
  return lengths;
}

} // namespace ndframe

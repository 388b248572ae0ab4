#include "length_field.hpp"

#include <cmath>
#include <functional>
#include <queue>
#include <utility>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/mesh/vertex_cells.hpp"

namespace ndframe
{

LengthField::LengthField(const Mesh& mesh, std::vector<double> lengths)
    : mesh_(mesh), cells_(mesh), lengths_(std::move(lengths))
{
  NDFRAME_ASSERT(lengths_.size() == std::size_t(mesh.numPoints()), "one length per vertex");
}

double LengthField::at(const std::array<double, 2>& point) const
{
  const CellLocator::Place place = cells_.find(point);
  double length = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
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
      for (int k = 0; k < 3; ++k) {
        const int w = mesh.cell(*cell)[k];
        const double distance = std::hypot(mesh.point(w)[0] - mesh.point(v)[0], mesh.point(w)[1] - mesh.point(v)[1]);
        if (length + slope * distance < lengths[std::size_t(w)])
          queue.emplace(lengths[std::size_t(w)] = length + slope * distance, w);
      }
  }
  return lengths;
}

} // namespace ndframe

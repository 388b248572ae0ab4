#include "ndframe/mesh/loose_vertices.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace ndframe
{
namespace
{

/// A move must leave every cell this part of its area.
constexpr double smallestArea = 0.5;
/// Sines of smaller angles are round-off.
constexpr double straight = 1e-9;

} // namespace

LooseVertices::LooseVertices(Mesh& mesh, const std::string& side) : mesh_(mesh), cells_(mesh)
{
  for (const Side& named : mesh.sides) {
    std::map<int, int> uses;
    for (const Facet facet : named.facets) {
      int ends[3];
      facetVertices(mesh, facet, ends);
      for (const int end : {ends[0], ends[1]})
        ++uses[end];
    }
    for (const auto& [vertex, count] : uses)
      if (count != 2)
        fixed_.insert(vertex);
  }
  keepCorners(side);
}

bool LooseVertices::move(int vertex, const double* to)
{
  if (fixed_.count(vertex) > 0)
    return false;
  double* x = mesh_.points.data() + std::ptrdiff_t(vertex) * 2;
  const std::array<double, 2> from{x[0], x[1]};
  std::vector<double> areas;
  for (const int* cell = cells_.begin(vertex); cell != cells_.end(vertex); ++cell)
    areas.push_back(cellMeasure(mesh_, *cell));
  std::copy_n(to, 2, x);
  const double* area = areas.data();
  for (const int* cell = cells_.begin(vertex); cell != cells_.end(vertex); ++cell)
    if (cellMeasure(mesh_, *cell) < smallestArea * *area++) {
      std::copy(from.begin(), from.end(), x);
      return false;
    }
  return true;
}

void LooseVertices::keepCorners(const std::string& side)
{
  std::map<int, std::array<double, 2>> normals;
  for (const Facet facet : mesh_.findSide(side)->facets) {
    int ends[3];
    double n[3];
    const double length = facetNormal(mesh_, facet, n);
    facetVertices(mesh_, facet, ends);
    for (const int end : {ends[0], ends[1]}) {
      const auto [known, isNew] = shortest_.insert({end, length});
      known->second = std::min(known->second, length);
      const auto [normal, first] = normals.insert({end, {n[0], n[1]}});
      if (!first && std::abs(normal->second[0] * n[1] - normal->second[1] * n[0]) > straight)
        fixed_.insert(end);
    }
  }
}

} // namespace ndframe

#include "remesh_sizes.hpp"

#include <algorithm>
#include <cmath>

#include "around_vertices.hpp"

namespace ndframe
{
namespace
{

/// Cells that contribute nothing may grow, but what is predicted for them does not reach far: their edges by 2.
double logMostGrowth(int dim)
{
  return dim;
}

/// Steps of log2 of a measure: gmsh answers round-off in a length, which differs from rank to rank, with another mesh.
constexpr double logMeasureStep = 1.0 / 64;

/// The length to ask for, by the root of the measure. gmsh's triangles have edges that are shorter on average.
double edgePerRoot(int dim)
{
  constexpr double shortfall = 0.95;
  return dim == 2 ? 2.0 / std::pow(3.0, 0.25) / shortfall : std::cbrt(6.0 * std::sqrt(2.0));
}

/// log2 of the measure that a part of an ancestor shall have.
double logMeasureOf(const Mesh& parts, int part, const CellSize& size, double ancestorMeasure)
{
  double wanted =
      std::min(size.logMeasureAt(cellCentre(parts, part)), std::log2(ancestorMeasure) + logMostGrowth(parts.dim));
  for (const FineSegment& segment : size.fine)
    if (segment.facetOn(parts, part) > 0.0)
      wanted = std::min(wanted, std::log2(cellMeasure(parts, part)));
  return wanted;
}

} // namespace

std::vector<double> lengthsOn(const Mesh& parts, const std::vector<int>& ancestors, const Mesh& mesh,
                              const std::vector<CellSize>& sizes)
{
  Vector lengths = meanAroundVertices(parts, [&](int c) {
    const auto ancestor = std::size_t(ancestors[std::size_t(c)]);
    return logMeasureOf(parts, c, sizes[ancestor], cellMeasure(mesh, int(ancestor)));
  });
  for (double& value : lengths)
    value = edgePerRoot(mesh.dim) * std::exp2(logMeasureStep * std::round(value / logMeasureStep) / mesh.dim);
  return lengths;
}

} // namespace ndframe

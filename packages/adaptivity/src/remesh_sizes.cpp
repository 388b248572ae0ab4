#include "remesh_sizes.hpp"

#include <algorithm>
#include <cmath>

#include "around_vertices.hpp"
#include "ndframe/mesh/cell_locator.hpp"

namespace ndframe
{
namespace
{

/// Cells that contribute nothing may grow, but what is predicted for them does not reach far: their edges by 2.
double logMostGrowth(int dim)
{
  return dim;
}

/// gmsh's edges are that much shorter on average than they should be.
constexpr double shortfall = 0.95;

/// Steps of log2 of a measure: gmsh answers round-off in a length, which differs from rank to rank, with another mesh.
constexpr double logMeasureStep = 1.0 / 64;

/// log2 of a measure is corrected by no more.
constexpr double mostCorrection = 2.0;

/// The length to ask gmsh for, by the root of the measure.
double edgePerRoot(int dim)
{
  const double ofRegular = dim == 2 ? 2.0 / std::pow(3.0, 0.25) : std::cbrt(6.0 * std::sqrt(2.0));
  return ofRegular / shortfall;
}

double rounded(double logMeasure)
{
  return logMeasureStep * std::round(logMeasure / logMeasureStep);
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

/// The lengths of a body anywhere in it.
class Lengths
{
public:
  explicit Lengths(const WantedMesh& wanted) : wanted_(wanted), cells_(wanted.background) {}

  double at(const std::array<double, 3>& point) const
  {
    const CellLocator::Place place = cells_.find(point);
    double length = 0.0;
    for (std::size_t k = 0; k < 4; ++k)
      length += place.weights[k] * wanted_.lengths[std::size_t(wanted_.background.cell(place.cell)[k])];
    return length;
  }

private:
  const WantedMesh& wanted_;
  CellLocator cells_;
};

} // namespace

std::vector<double> lengthsOn(const Mesh& parts, const std::vector<int>& ancestors, const Mesh& mesh,
                              const std::vector<CellSize>& sizes)
{
  Vector lengths = meanAroundVertices(parts, [&](int c) {
    const auto ancestor = std::size_t(ancestors[std::size_t(c)]);
    return logMeasureOf(parts, c, sizes[ancestor], cellMeasure(mesh, int(ancestor)));
  });
  for (double& value : lengths)
    value = edgePerRoot(mesh.dim) * std::exp2(rounded(value) / mesh.dim);
  return lengths;
}

std::vector<WantedMesh> correctedLengths(const std::vector<WantedMesh>& wanted, const std::vector<Mesh>& made)
{
  std::vector<WantedMesh> next;
  for (std::size_t b = 0; b < made.size(); ++b) {
    const Mesh& mesh = made[b];
    const Lengths lengths(wanted[b]);
    const Vector tooLarge = meanAroundVertices(mesh, [&](int c) {
      return std::log2(cellMeasure(mesh, c)) - 3.0 * std::log2(lengths.at(cellCentre(mesh, c)) / edgePerRoot(3));
    });
    next.push_back({mesh, {}});
    for (int v = 0; v < mesh.numPoints(); ++v) {
      const double *x = mesh.point(v),
                   correction = std::clamp(rounded(tooLarge[std::size_t(v)]), -mostCorrection, mostCorrection);
      next.back().lengths.push_back(lengths.at({x[0], x[1], x[2]}) * std::exp2(-correction / 3.0));
    }
  }
  return next;
}

} // namespace ndframe

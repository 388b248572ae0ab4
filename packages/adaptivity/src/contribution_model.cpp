#include "ndframe/adaptivity/contribution_model.hpp"

#include <algorithm>
#include <cmath>

#include "around_vertices.hpp"

namespace ndframe
{
namespace
{

/// Below 1 stresses are infinite at a vertex; up to 1.5 (where contact ends) smooth refinement is slow, too.
bool isCorner(double exponent)
{
  return exponent <= 1.5;
}

/// Squared distance of the centre of a cell from the place that it touches, for meshes made anew.
double typicalSquare(double volume)
{
  constexpr double byRoot = 1.05; // 0.7 of regular cells along an edge, up to 1.25 of those with one vertex on it
  return std::pow(byRoot * std::cbrt(volume), 2);
}

ContributionModel::Cell cellOf(const Mesh& mesh, int cell, double measure, double contribution,
                               const Vector& ofVertices, const std::vector<std::array<double, 3>>* directions,
                               ErrorDecay decay)
{
  const auto smaller = [&](int v, int w) { return ofVertices[std::size_t(v)] < ofVertices[std::size_t(w)]; };
  const int vertex = *std::min_element(mesh.cell(cell), mesh.cell(cell) + mesh.dim + 1, smaller);
  const double exponent = ofVertices[std::size_t(vertex)];
  const bool atPlace = isCorner(exponent);
  SingularPlace place;
  std::copy_n(mesh.point(vertex), mesh.dim, place.point.begin());
  if (directions)
    place.direction = (*directions)[std::size_t(vertex)];
  return {{2.0 * std::log2(contribution), atPlace ? exponent : decay.smoothExponent()},
          measure,
          atPlace,
          place,
          place.squaredDistance(cellCentre(mesh, cell))};
}

} // namespace

ContributionModel::ContributionModel(const std::vector<Mesh>& meshes, const std::vector<Vector>& contributions,
                                     const std::vector<Vector>& exponents, int degree, const EdgeDirections& directions,
                                     bool areMadeAnew)
    : decay_{degree, meshes.front().dim}, areMadeAnew_(areMadeAnew), cells_(meshes.size())
{
  for (std::size_t b = 0; b < meshes.size(); ++b) {
    const Vector measures = measuresOf(meshes[b]);
    for (int c = 0; c < meshes[b].numCells(); ++c) {
      cells_[b].push_back(cellOf(meshes[b], c, measures[std::size_t(c)], contributions[b][std::size_t(c)], exponents[b],
                                 directions.empty() ? nullptr : &directions[b], decay_));
      if (areMadeAnew_)
        cells_[b].back().squaredDistance = typicalSquare(measures[std::size_t(c)]);
    }
  }
}

Vector ContributionModel::measuresOf(const Mesh& mesh) const
{
  Vector measures;
  for (int c = 0; c < mesh.numCells(); ++c)
    measures.push_back(cellMeasure(mesh, c));
  if (!areMadeAnew_)
    return measures;
  const Vector logs = meanAroundVertices(mesh, [&](int c) { return std::log2(measures[std::size_t(c)]); });
  for (int c = 0; c < mesh.numCells(); ++c) {
    double sum = 0.0;
    for (int k = 0; k <= mesh.dim; ++k)
      sum += logs[std::size_t(mesh.cell(c)[k])];
    measures[std::size_t(c)] = std::exp2(sum / (mesh.dim + 1));
  }
  return measures;
}

std::vector<std::vector<CellDecay>> ContributionModel::decays() const
{
  std::vector<std::vector<CellDecay>> decays;
  for (const auto& body : cells_) {
    decays.emplace_back();
    for (const Cell& cell : body)
      decays.back().push_back(cell.decay);
  }
  return decays;
}

double ContributionModel::logSquared(const Cell& cell, double measure, const std::array<double, 3>& centre) const
{
  const double smooth = cell.decay.logSquared + decay_.ofCell() * std::log2(measure / cell.measure);
  if (!cell.atPlace)
    return smooth;
  double square = cell.place.squaredDistance(centre);
  if (areMadeAnew_)
    square = std::max(square, typicalSquare(measure));
  const double nearer = std::log2(square / cell.squaredDistance);
  return smooth + (cell.decay.exponent - 1.0 - decay_.degree) * nearer;
}

double ContributionModel::errorOn(const std::vector<Mesh>& meshes, const std::vector<std::vector<int>>& ancestors) const
{
  double squared = 0.0;
  for (std::size_t b = 0; b < meshes.size(); ++b) {
    const Vector measures = measuresOf(meshes[b]);
    for (int c = 0; c < meshes[b].numCells(); ++c) {
      const Cell& ancestor = cells_[b][std::size_t(ancestors[b][std::size_t(c)])];
      squared += std::exp2(logSquared(ancestor, measures[std::size_t(c)], cellCentre(meshes[b], c)));
    }
  }
  return std::sqrt(squared);
}

} // namespace ndframe

#include "ndframe/adaptivity/contribution_model.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

/// Below 1 stresses are infinite at a vertex; up to 1.5 (where contact ends) smooth refinement is slow, too.
bool isCorner(double exponent)
{
  return exponent <= 1.5;
}

double squaredDistance(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
}

ContributionModel::Cell cellOf(const Mesh& mesh, int cell, double contribution, const Vector& ofVertices, int degree)
{
  const auto smaller = [&](int v, int w) { return ofVertices[std::size_t(v)] < ofVertices[std::size_t(w)]; };
  const int vertex = *std::min_element(mesh.cell(cell), mesh.cell(cell) + 3, smaller);
  const double exponent = ofVertices[std::size_t(vertex)];
  const bool atCorner = isCorner(exponent);
  const std::array<double, 3> corner{mesh.point(vertex)[0], mesh.point(vertex)[1], 0.0};
  return {{2.0 * std::log2(contribution), atCorner ? exponent : degree + 1.0},
          cellMeasure(mesh, cell),
          atCorner,
          corner,
          squaredDistance(cellCentre(mesh, cell), corner)};
}

} // namespace

ContributionModel::ContributionModel(const std::vector<Mesh>& meshes, const std::vector<Vector>& contributions,
                                     const std::vector<Vector>& exponents, int degree)
    : degree_(degree), cells_(meshes.size())
{
  for (const Mesh& mesh : meshes)
    NDFRAME_ASSERT(mesh.dim == 2, "sizes are those of triangles");
  for (std::size_t b = 0; b < meshes.size(); ++b)
    for (int c = 0; c < meshes[b].numCells(); ++c)
      cells_[b].push_back(cellOf(meshes[b], c, contributions[b][std::size_t(c)], exponents[b], degree));
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

double ContributionModel::logSquared(const Cell& cell, double area, const std::array<double, 3>& centre) const
{
  const double smooth = cell.decay.logSquared + (degree_ + 1) * std::log2(area / cell.area);
  if (!cell.atCorner)
    return smooth;
  const double nearer = std::log2(squaredDistance(centre, cell.corner) / cell.squaredDistance);
  return smooth + (cell.decay.exponent - 1.0 - degree_) * nearer;
}

double ContributionModel::errorOn(const std::vector<Mesh>& meshes, const std::vector<std::vector<int>>& ancestors) const
{
  double squared = 0.0;
  for (std::size_t b = 0; b < meshes.size(); ++b)
    for (int c = 0; c < meshes[b].numCells(); ++c) {
      const Cell& ancestor = cells_[b][std::size_t(ancestors[b][std::size_t(c)])];
      squared += std::exp2(logSquared(ancestor, cellMeasure(meshes[b], c), cellCentre(meshes[b], c)));
    }
  return std::sqrt(squared);
}

} // namespace ndframe

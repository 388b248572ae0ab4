#include "ndframe/estimation/graded_refinement.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ndframe
{
namespace
{

/// Below 1 stresses are infinite at a vertex; between 1 and 1.5 (where contact ends) smooth refinement is slow, too.
bool isCorner(double exponent)
{
  return exponent < 1.5;
}

/// Smooth cells are halved at most so often at once, cells at a corner twice as often.
constexpr int mostHalvings = 8;

double squaredDistance(const Mesh& mesh, int cell, const std::array<double, 2>& from)
{
  double squared = 0.0;
  for (int k = 0; k < 2; ++k) {
    double centre = 0.0;
    for (int v = 0; v < 3; ++v)
      centre += mesh.point(mesh.cell(cell)[v])[k] / 3.0;
    squared += (centre - from[std::size_t(k)]) * (centre - from[std::size_t(k)]);
  }
  return squared;
}

} // namespace

GradedRefinement::GradedRefinement(const std::vector<Mesh>& meshes, const std::vector<Vector>& contributions,
                                   const CornerExponents& exponents, int degree)
    : degree_(degree), cells_(meshes.size()), origins_(meshes.size())
{
  for (std::size_t b = 0; b < meshes.size(); ++b)
    for (int c = 0; c < meshes[b].numCells(); ++c) {
      const Vector& ofVertices = exponents.exponents()[b];
      const auto smaller = [&](int v, int w) { return ofVertices[std::size_t(v)] < ofVertices[std::size_t(w)]; };
      const int vertex = *std::min_element(meshes[b].cell(c), meshes[b].cell(c) + 3, smaller);
      CellDecay decay{2.0 * std::log2(contributions[b][std::size_t(c)]), ofVertices[std::size_t(vertex)]};
      Origin origin;
      origin.atCorner = isCorner(decay.exponent);
      if (origin.atCorner) {
        origin.corner = {meshes[b].point(vertex)[0], meshes[b].point(vertex)[1]};
        origin.area = cellMeasure(meshes[b], c);
        origin.squaredDistance = squaredDistance(meshes[b], c, origin.corner);
      } else {
        decay.exponent = degree + 1.0;
      }
      cells_[b].push_back(decay);
      origins_[b].push_back(origin);
    }
}

Prediction GradedRefinement::predict(double target) const
{
  return predictRefinement(cells_, target, degree_);
}

double GradedRefinement::logSquared(std::size_t body, std::size_t ancestor, const Mesh& mesh, int cell) const
{
  const Origin& origin = origins_[body][ancestor];
  const CellDecay& decay = cells_[body][ancestor];
  const double smaller = std::log2(cellMeasure(mesh, cell) / origin.area);
  const double nearer = std::log2(squaredDistance(mesh, cell, origin.corner) / origin.squaredDistance);
  return decay.logSquared + (degree_ + 1) * smaller + (decay.exponent - 1.0 - degree_) * nearer;
}

int GradedRefinement::halvingsOf(std::size_t body, std::size_t ancestor, const Mesh& mesh, int cell, bool first,
                                 double level) const
{
  const Origin& origin = origins_[body][ancestor];
  if (!origin.atCorner)
    return first ? std::min(mostHalvings, smoothHalvings(cells_[body][ancestor].logSquared, level, degree_)) : 0;
  if (cellMeasure(mesh, cell) < std::exp2(-2 * mostHalvings) * origin.area)
    return 0;
  return std::min(1, smoothHalvings(logSquared(body, ancestor, mesh, cell), level, degree_));
}

void GradedRefinement::apply(Bisection& bisection, const Prediction& prediction) const
{
  std::vector<std::vector<int>> ancestors;
  for (const auto& cells : cells_) {
    ancestors.emplace_back(cells.size());
    std::iota(ancestors.back().begin(), ancestors.back().end(), 0);
  }
  for (bool first = true;; first = false) {
    bool wanted = false;
    std::vector<std::vector<int>> halvings(cells_.size());
    for (std::size_t b = 0; b < cells_.size(); ++b)
      for (std::size_t c = 0; c < ancestors[b].size(); ++c) {
        halvings[b].push_back(
            halvingsOf(b, std::size_t(ancestors[b][c]), bisection.meshes()[b], int(c), first, prediction.level));
        wanted = wanted || halvings[b].back() > 0;
      }
    if (!wanted)
      return;
    bisection.refine(halvings);
    for (std::size_t b = 0; b < cells_.size(); ++b) {
      std::vector<int> inherited;
      for (const int parent : bisection.parents()[b])
        inherited.push_back(ancestors[b][std::size_t(parent)]);
      ancestors[b] = std::move(inherited);
    }
  }
}

} // namespace ndframe

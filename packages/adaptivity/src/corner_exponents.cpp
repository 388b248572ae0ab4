#include "ndframe/adaptivity/corner_exponents.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

/// Stars that became smaller by less teach nothing.
constexpr double clearlySmaller = 0.6;
/// Corners may have less (a crack 0.5), but so has noise on coarse meshes, and the next meshes correct what is missing.
constexpr double smallest = 0.7;

/// Is vertex v where it was among these points?
bool isAt(const Mesh& mesh, std::size_t v, const Vector& points)
{
  const auto first = std::ptrdiff_t(v) * mesh.dim, last = first + mesh.dim;
  return last <= std::ptrdiff_t(points.size()) &&
         std::equal(points.begin() + first, points.begin() + last, mesh.points.begin() + first);
}

} // namespace

void CornerExponents::observe(const std::vector<const Mesh*>& meshes, const std::vector<Vector>& contributions)
{
  stars_.resize(meshes.size());
  exponents_.resize(meshes.size());
  if (firstPoints_.empty())
    for (const Mesh* mesh : meshes)
      firstPoints_.push_back(mesh->points);
  for (std::size_t b = 0; b < meshes.size(); ++b) {
    const Mesh& mesh = *meshes[b];
    NDFRAME_ASSERT(contributions[b].size() == std::size_t(mesh.numCells()), "one contribution per cell is needed");
    Stars now{Vector(std::size_t(mesh.numPoints()), 0.0), Vector(std::size_t(mesh.numPoints()), 0.0)};
    for (int c = 0; c < mesh.numCells(); ++c)
      for (int v = 0; v <= mesh.dim; ++v) {
        const auto vertex = std::size_t(mesh.cell(c)[v]);
        now.squared[vertex] += std::pow(contributions[b][std::size_t(c)], 2);
        now.area[vertex] += cellMeasure(mesh, c);
      }
    const Stars& before = stars_[b];
    Vector& exponents = exponents_[b];
    exponents.resize(now.area.size(), smooth_);
    for (std::size_t v = 0; v < std::min(before.area.size(), now.area.size()); ++v)
      if (isAt(mesh, v, firstPoints_[b]) && now.area[v] <= clearlySmaller * before.area[v] && now.squared[v] > 0.0 &&
          before.squared[v] > 0.0)
        exponents[v] = std::clamp(std::log(now.squared[v] / before.squared[v]) / std::log(now.area[v] / before.area[v]),
                                  smallest, smooth_);
    stars_[b] = std::move(now);
  }
}

} // namespace ndframe

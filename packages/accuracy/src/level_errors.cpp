#include "ndframe/accuracy/level_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ndframe/mesh/shape.hpp"
#include "ndframe/run/energy_comparison.hpp"

namespace ndframe
{
namespace
{

/// Where the largest contribution is.
void findWorst(const Run& run, LevelSummary& level)
{
  double largest = -1.0;
  for (std::size_t b = 0; b < run.model.bodies.size(); ++b) {
    const Vector& eta = run.certificate->etaGlobal[b];
    const auto worst = std::max_element(eta.begin(), eta.end());
    if (worst == eta.end() || *worst <= largest)
      continue;
    largest = *worst;
    const Mesh& mesh = run.model.bodies[b].mesh;
    const auto centre = cellCentre(mesh, int(worst - eta.begin()));
    level.worstBody = run.model.bodies[b].name;
    level.worstPoint.assign(centre.begin(), centre.begin() + mesh.dim);
  }
}

} // namespace

LevelErrors::LevelErrors(const Run& run, const AccuracyOptions& options)
{
  const ErrorSummary& errors = run.certificate->summary;
  const ErrorMeasureSummary& global = *errors.global;
  const double norm = global.relative > 0.0 ? global.absolute / global.relative : 0.0;
  bound = options.of == AccuracyOf::Displacement ? global.absolute : *errors.meanStress;
  relative = norm > 0.0 ? bound / norm : 0.0;
  target = options.target * (options.relative ? norm : 1.0);
  if (!run.solved.coupling.history.empty())
    iteration = run.solved.coupling.history.back().iterationError.value_or(0.0);
  contact = global.contact;
  mesh = std::sqrt(std::max(0.0, global.absolute * global.absolute - iteration * iteration));
}

bool LevelErrors::mayBeOfSweeps(const std::vector<LevelSummary>& before) const
{
  constexpr double shareOfContact = 0.5; // of the bound
  const bool rises = !before.empty() && bound > before.back().bound;
  return rises || contact > shareOfContact * bound;
}

double LevelErrors::iterationToTarget() const
{
  const double allowed = target / bound * std::hypot(mesh, iteration); // of the whole
  if (reached() || allowed <= mesh)
    return std::numeric_limits<double>::infinity();
  return std::sqrt(allowed * allowed - mesh * mesh);
}

LevelSummary summarizeLevel(const Run& run, const LevelErrors& errors)
{
  LevelSummary level;
  level.dofs = run.model.totalDofs();
  for (const auto& body : run.model.bodies) {
    level.elements += body.mesh.numCells();
    level.worstShape = std::min(level.worstShape, worstShape(body.mesh));
  }
  level.bound = errors.bound;
  level.relative = errors.relative;
  level.iteration = errors.iteration;
  level.mesh = errors.mesh;
  level.energy = bracketOf(run.energy);
  if (!run.certificate->summary.guaranteed)
    level.doubt = run.certificate->summary.reason;
  findWorst(run, level);
  return level;
}

} // namespace ndframe

#include "ndframe/accuracy/level_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ndframe/algebra/shared_values.hpp"
#include "ndframe/mesh/shape.hpp"
#include "ndframe/run/energy_comparison.hpp"

namespace ndframe
{
namespace
{

constexpr double equallyLarge = 1e-6; ///< fields on several ranks are as exact as this

/// Where the largest contribution is, of equally large ones the first, among the cells as they were refined.
void findWorst(const Model& model, const std::vector<const Mesh*>& meshes, const std::vector<Vector>& contributions,
               LevelSummary& level)
{
  const std::vector<int> bodies = model.elasticBodies();
  double largest = -1.0;
  for (std::size_t b = 0; b < contributions.size(); ++b) {
    const Vector& eta = contributions[b];
    const double most = *std::max_element(eta.begin(), eta.end());
    const auto worst = std::find_if(eta.begin(), eta.end(), [&](double e) { return e >= (1.0 - equallyLarge) * most; });
    if (worst == eta.end() || *worst <= (1.0 + equallyLarge) * largest)
      continue;
    largest = *worst;
    const auto centre = cellCentre(*meshes[b], int(worst - eta.begin()));
    level.worstBody = model.bodies[std::size_t(bodies[b])].name;
    level.worstPoint.assign(centre.begin(), centre.begin() + meshes[b]->dim);
  }
}

/// The worst cell of a body counts, whoever has it. Collective.
double worstShape(const BodyModel& body, const Comm& comm)
{
  Vector worst{worstShape(body.mesh)}, none;
  if (body.share)
    takeExtremes(worst, none, comm);
  return worst[0];
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

LevelSummary summarizeLevel(const Run& run, const std::vector<const Mesh*>& meshes, const LevelLesson& lesson,
                            const Comm& comm)
{
  LevelSummary level;
  level.dofs = run.model.totalDofs();
  for (const auto& body : run.model.bodies) {
    level.elements += body.share ? body.share->numCells() : body.mesh.numCells();
    level.worstShape = std::min(level.worstShape, worstShape(body, comm));
  }
  const LevelNumbers& errors = lesson.errors;
  level.bound = errors.bound;
  level.relative = errors.relative;
  level.iteration = errors.iteration;
  level.mesh = errors.mesh;
  level.energy = bracketOf(run.energy);
  if (!run.certificate->summary.guaranteed)
    level.doubt = run.certificate->summary.reason;
  findWorst(run.model, meshes, lesson.contributions, level);
  return level;
}

} // namespace ndframe

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ndframe/base/expression.hpp"
#include "ndframe/run/energy_comparison.hpp"

namespace ndframe
{
namespace
{

/// Nodal forces of a load with one direction are parallel to this, relative to the largest.
constexpr double parallel = 1e-10;

NumberBracket times(double factor, NumberBracket bracket)
{
  const double a = factor * bracket.lower, b = factor * bracket.upper;
  return {std::min(a, b), std::max(a, b)};
}

/// No gap, neither of the deck nor of the drawing.
bool isGapless(const Model& model)
{
  return std::all_of(model.interfaces.begin(), model.interfaces.end(), [&](const InterfaceMesh& interface) {
    return std::all_of(interface.drawnGap.begin(), interface.drawnGap.end(), [](double gap) { return gap == 0.0; }) &&
           interface.gapFunction.tree->isConstant() &&
           valueAt(interface.gapFunction, interface.dim, interface.point(0)) == 0.0;
  });
}

/// The displacement that a constant support prescribes, along its directions.
Direction prescribedBy(const Support& support, const Mesh& mesh)
{
  Direction u{};
  const std::vector<Direction> directions = support.directions(mesh);
  const std::vector<SampledFunction>& functions = support.functions();
  for (std::size_t k = 0; k < functions.size(); ++k)
    for (std::size_t i = 0; i < u.size(); ++i)
      u[i] += valueAt(functions[k], mesh.dim, mesh.point(0)) * directions[k][i];
  return u;
}

double lengthOf(const Direction& vector)
{
  return std::sqrt(dotProduct(vector, vector));
}

/// What moves the bodies.
struct Causes
{
  int loads = 0, movingSupports = 0;
  bool supportsAreConstant = true;
  std::size_t body = 0; ///< of the last load or moving support
  const SideCondition* last = nullptr;
  double displacement = 0.0; ///< that the last moving support prescribes
  bool loadIsConstant = false;

  std::string name(const Model& model) const { return last->params().name() + " of " + model.bodies[body].name; }
};

Causes causesOf(const Model& model)
{
  Causes causes;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyModel& body = model.bodies[b];
    for (const auto& load : body.loads) {
      ++causes.loads;
      causes.body = b;
      causes.last = load.get();
      causes.loadIsConstant = load->isConstant(body.mesh.dim);
    }
    for (const auto& support : body.supports) {
      causes.supportsAreConstant = causes.supportsAreConstant && support->isConstant();
      const double moves = support->isConstant() ? lengthOf(prescribedBy(*support, body.mesh)) : 0.0;
      if (moves == 0.0)
        continue;
      ++causes.movingSupports;
      causes.body = b;
      causes.last = support.get();
      causes.displacement = moves;
    }
  }
  return causes;
}

/// The resultant of a load with one direction everywhere; 0 for others.
double forceOf(const Vector& load, int dim)
{
  Direction sum{};
  const auto n = std::size_t(dim);
  double largest = 0.0;
  for (std::size_t i = 0; i < load.size(); ++i) {
    sum[i % n] += load[i];
    largest = std::max(largest, std::abs(load[i]));
  }
  const double force = lengthOf(sum);
  for (std::size_t i = 0; i < load.size(); i += n) {
    double along = 0.0;
    for (std::size_t k = 0; k < n; ++k)
      along += load[i + k] * sum[k] / force;
    for (std::size_t k = 0; k < n; ++k)
      if (!(std::abs(load[i + k] - along * sum[k] / force) <= parallel * largest))
        return 0.0;
  }
  return force;
}

/// One load: E = -W / 2, W = force times mean displacement.
void addWorkOfLoads(EnergySummary& summary, const Model& model, const Causes& causes)
{
  summary.workOf = "the loads";
  const NumberBracket work = *(summary.work = times(-2.0, summary.energy));
  const double force = causes.loads == 1 && causes.loadIsConstant
                           ? forceOf(model.loads[causes.body].all(), model.bodies[causes.body].mesh.dim)
                           : 0.0;
  if (force > 0.0 && work.lower > 0.0)
    summary.drive = DriveSummary{causes.name(model),
                                 {force, force},
                                 times(1.0 / force, work),
                                 {force * force / work.upper, force * force / work.lower}};
}

/// One moving support: E = W / 2, W = displacement times force.
void addWorkOfSupports(EnergySummary& summary, const Model& model, const Causes& causes)
{
  summary.workOf = "the supports";
  const NumberBracket work = *(summary.work = times(2.0, summary.energy));
  const double u = causes.displacement;
  if (causes.movingSupports == 1)
    summary.drive = DriveSummary{causes.name(model), times(1.0 / u, work), {u, u}, times(1.0 / (u * u), work)};
}

} // namespace

std::optional<NumberBracket> bracketOf(const EnergyRecord& record)
{
  if (record.certificates() == 0 || !record.holds())
    return std::nullopt;
  return NumberBracket{std::min(record.lower(), record.upper()), std::max(record.lower(), record.upper())};
}

std::optional<EnergySummary> summarizeEnergy(const Run& run, double strainEnergy)
{
  const auto bracket = bracketOf(run.energy);
  if (!bracket)
    return std::nullopt;
  EnergySummary summary;
  summary.energy = *bracket;
  summary.certificates = run.energy.certificates();
  summary.relativeWidth = strainEnergy > 0.0 ? (bracket->upper - bracket->lower) / strainEnergy : 0.0;
  const Causes causes = causesOf(run.model);
  if (!causes.supportsAreConstant || !isGapless(run.model))
    return summary;
  if (causes.movingSupports == 0 && causes.loads > 0)
    addWorkOfLoads(summary, run.model, causes);
  else if (causes.movingSupports > 0 && causes.loads == 0)
    addWorkOfSupports(summary, run.model, causes);
  return summary;
}

} // namespace ndframe

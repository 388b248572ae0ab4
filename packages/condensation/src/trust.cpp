#include "ndframe/condensation/trust.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ndframe/algebra/shared_values.hpp"
#include "ndframe/scene/regions.hpp"

namespace ndframe
{
namespace
{

/// A displacement is at most about a force over a modulus, an energy the product of both, a norm sums squares of
/// those: with all of them between 1e-50 and 1e50 nothing overflows, and what underflows is round-off.
constexpr double largestNumber = 1e50;

/// Contact forces below this are round-off: relative to the largest load, and to the largest K_ii u.
constexpr double noForce = 1e-11, noStiffForce = 1e-13;

/// Unlike largestEntry(): NaN where a value is.
double largest(const std::vector<double>& values)
{
  double m = 0.0;
  for (const double value : values)
    m = std::isnan(value) ? value : std::max(m, std::abs(value));
  return m;
}

double largestPrescribed(const ConstraintSet& constraints)
{
  double m = 0.0;
  for (const auto& [node, given] : constraints.nodes())
    for (int k = 0; k < given.count; ++k)
      m = std::max(m, std::abs(given.value[std::size_t(k)]));
  return m;
}

/// Adds a mistake at `key` of `list` when the number is too large, or too small although it is not zero.
void checkRange(double number, const ListPlace& list, const char* key, const char* what, Diagnostics& diagnostics)
{
  if (number != 0.0 && !(number <= largestNumber && number >= 1.0 / largestNumber))
    diagnostics.add(list.mistake(
        key, fmt::format("{} reach {:.3g}: products of such numbers leave the range of floating-point numbers; "
                         "choose units in which they lie between {:g} and {:g}.",
                         what, number, 1.0 / largestNumber, largestNumber)));
}

/// Of all materials of a body; each is checked.
double largestModulus(const BodyModel& body, const BodySettings& settings, Diagnostics& diagnostics)
{
  double largestOfAll = 0.0;
  for (const auto& [list, law] : materialsOf(body, settings)) {
    const double modulus = largest({law.D.begin(), law.D.end()});
    checkRange(modulus, ListPlace(list), "", "the elastic moduli", diagnostics);
    largestOfAll = std::max(largestOfAll, modulus);
  }
  return largestOfAll;
}

double largestContactForce(const BodyTrace& trace, const InterfaceState& state)
{
  return largestEntry(trace.forces(state.forceDirichlet, state.forceNeumann));
}

/// What contact forces must exceed in this scene to be more than round-off.
double smallestContactForce(const CondensedModel& condensed, const std::vector<BodyFields>& fields, const Comm& comm)
{
  double smallest = 0.0;
  for (std::size_t b = 0; b < fields.size(); ++b) {
    const BodySystem& system = condensed.systems[b];
    Vector largest{largestEntry(fields[b].displacement.back()), system.load.largest()};
    if (system.share)
      takeLargest(largest, comm);
    const double stiff = system.largestDiagonal(comm) * largest[0];
    smallest = std::max({smallest, noForce * largest[1], noStiffForce * stiff});
  }
  return smallest;
}

/// A limit on one of the residuals, and what it means when it is passed.
struct Limit
{
  double residual, allowed;
  const char* meaning;
};

} // namespace

void checkNumberRange(const Model& model, const SceneSettings& scene, Diagnostics& diagnostics)
{
  double driving = 0.0; // a small load beside a large one does no harm
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyModel& body = model.bodies[b];
    const double size = largest(body.mesh.points), modulus = largestModulus(body, scene.bodies[b], diagnostics);
    checkRange(size, ListPlace(scene.bodies[b].shape), "", "the coordinates", diagnostics);
    const double prescribed = modulus * std::pow(size, body.mesh.dim - 2) * largestPrescribed(model.constraints[b]);
    driving = largest({driving, model.loads[b].largest(), prescribed});
  }
  checkRange(driving, scene.bodiesPlace, "", "the nodal forces of loads and prescribed displacements", diagnostics);
  for (const auto& interface : model.interfaces)
    checkRange(largest({1.0, largest(interface.gap)}), scene.interface(interface.name).place, "Gap",
               "the values of Gap", diagnostics);
}

std::string undecidedContact(const Model& model, const CondensedModel& condensed, const InterfaceState& state,
                             const std::vector<BodyFields>& fields, const Comm& comm)
{
  std::vector<std::size_t> floating;
  for (std::size_t b = 0; b < fields.size(); ++b)
    if (const BodyTrace* trace = condensed.trace(int(b)); trace != nullptr && trace->freeMotions.cols() > 0)
      floating.push_back(b);
  if (floating.empty())
    return {};
  const double smallest = smallestContactForce(condensed, fields, comm);
  for (const std::size_t b : floating) {
    const BodyTrace& trace = *condensed.trace(int(b));
    if (const double force = largestContactForce(trace, state); smallest > 0.0 && force <= smallest)
      return fmt::format(
          "contact is undecided: nothing presses \"{}\" against what could hold it (largest contact force {:.1e}, of "
          "which {:.1e} may be round-off), and nothing else stops {}; load it or support it",
          model.bodies[b].name, force, smallest, fmt::join(trace.motionNames, ", "));
  }
  return {};
}

std::string passedLimit(const ResidualSummary& residuals)
{
  const ResidualLimits limits = ResidualLimits::of(residuals);
  for (const auto& [residual, allowed, meaning] :
       {Limit{residuals.equilibrium, limits.equilibrium,
              "the forces are out of balance by {:.1e}: the matrix is too ill-conditioned"},
        Limit{residuals.penetration, limits.contact, "the bodies penetrate by {:.1e} of the largest displacement"},
        Limit{residuals.tension, limits.contact, "contact pulls with {:.1e} of the largest force"},
        Limit{residuals.complementarity, limits.contact, "contact presses across an opening (complementarity {:.1e})"}})
    if (!(residual <= allowed))
      return fmt::format(fmt::runtime(meaning), residual);
  return {};
}

} // namespace ndframe

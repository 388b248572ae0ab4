#pragma once

#include <string>

#include "ndframe/condensation/condensed_model.hpp"
#include "ndframe/condensation/solution.hpp"
#include "ndframe/scene/model.hpp"

namespace ndframe
{

/// Refuses scenes whose sizes, moduli, loads or gaps are so large or small that products of them leave the range of
/// floating-point numbers, where results become zero or infinite without notice. Only other units help. `scene`: the
/// model's.
void checkNumberRange(const Model& model, const SceneSettings& scene, Diagnostics& diagnostics);

/// What the true residuals (ResidualSummary) may be at most. In a Neumann-Dirichlet iteration u1 and u2 of the final
/// pairing belong to the same sweep, so the conditions of contact hold to round-off however early it stops; what the
/// stopping tolerance leaves open is only the difference of the two tractions.
struct ResidualLimits
{
  double equilibrium = 1e-7; ///< of the largest force: beyond it less than six digits are right
  double contact = 1e-8;     ///< complementarity, penetration, tension

  /// What the coupling was asked for, if that is less.
  static ResidualLimits of(const ResidualSummary& residuals)
  {
    ResidualLimits limits;
    limits.contact = std::max(limits.contact, residuals.allowedInContact);
    return limits;
  }
};

/// Names a body that contact alone can hold and that no contact force presses on anything: where it is, only round-off
/// has decided, however well the equations are met. Empty when there is none, and for a scene at rest (nothing loaded,
/// nothing moved). `fields` are those of `state`, the last ones kept.
std::string undecidedContact(const Model& model, const CondensedModel& condensed, const InterfaceState& state,
                             const std::vector<BodyFields>& fields, const Comm& comm);

/// Names the first residual above its limit, in words; empty when there is none. One that is not a number passes its
/// limit.
std::string passedLimit(const ResidualSummary& residuals);

} // namespace ndframe

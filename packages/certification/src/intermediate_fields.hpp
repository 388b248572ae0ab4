#pragma once

#include "ndframe/admissibility/contact_moments.hpp"
#include "ndframe/condensation/condensed_model.hpp"
#include "ndframe/condensation/solution.hpp"

namespace ndframe
{

/// What fields are for: what they lack of finite element equilibrium is made up for by settleBalance(), which has to be
/// little, or by a recovery that takes any (StressRecovery::settles).
struct FieldNeed
{
  bool isNear = false; ///< for the latter, where bodies are solved whole: no solve, but nearField()
  double enough = 0.0; ///< for that
  Comm comm = Comm::single();
};

/// Finite element solutions of one body under given interface tractions, (40).
///
/// forces: per field the nodal contact forces (numDofs, global axes, contactForces()), which must balance the loads if
/// the body floats; solved: u_h, a solution under the forces `known` (same layout). A field whose forces are those of
/// u_h to round-off is u_h itself and costs nothing; the others cost one back-solve together, no factorisation. The
/// rigid motion of a floating body is that of u_h. Result: per field, global axes.
std::vector<NodalField> intermediateFields(const Model& model, const CondensedModel& condensed, int body,
                                           const std::vector<NodalField>& forces, const Vector& known,
                                           const NodalField& solved, const FieldNeed& need);

/// The nodal contact forces under which the algorithm solved a body: C Lambda along the nodes' normals, global axes.
Vector solvedForces(const CondensedModel& condensed, int body, const InterfaceState& state);

} // namespace ndframe

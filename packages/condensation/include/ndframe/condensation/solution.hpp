#pragma once

#include <vector>

#include "ndframe/condensation/condensed_model.hpp"
#include "ndframe/condensation/contact_node.hpp"
#include "ndframe/coupling/coupling.hpp"

namespace ndframe
{

/// The displacement fields that belong to interface states.
struct BodyFields
{
  std::vector<NodalField> u; ///< per state, in the nodes' own axes, without the free motions that the coupling
                             ///< found separately: strains have all their digits
  std::vector<NodalField> displacement; ///< per state, global axes (numNodes * dim), with all motions
  NodalField forces;                    ///< K u of the last state, in the nodes' own axes, as BodySystem::forcesOf
};

/// True residuals of the returned state, each relative to a scale of the same unit (0 is perfect).
struct ResidualSummary
{
  double equilibrium = 0.0; ///< largest |K u - f - contact force| over the free dofs / largest nodal load or reaction
  double complementarity = 0.0;  ///< max |(u1_N - u2_N - g)_i (C Lambda)_i| / (max |gap or u| * max nodal force)
  double penetration = 0.0;      ///< largest positive u1_N - u2_N - g / largest |u|
  double tension = 0.0;          ///< largest positive nodal contact force / largest nodal force
  double allowedInContact = 0.0; ///< the last three, by a coupling that was told to stop early
};

/// Interiors recovered by one multi-right-hand-side back-solve per body, (25) and (26). One entry per body; without
/// interfaces `states` holds one empty state. Collective where ranks have shares.
std::vector<BodyFields> recoverFields(const Model& model, const CondensedModel& condensed,
                                      const std::vector<InterfaceState>& states, const Comm& comm, Ledger& ledger);

/// Every interface node with its displacements and tractions; nodes in the order of the contact matrix.
std::vector<ContactNode> contactNodes(const Model& model, const CondensedModel& condensed, const InterfaceState& state,
                                      const std::vector<BodyFields>& fields, std::size_t step);

/// True residuals of a state, from the assembled systems and not from the solvers.
ResidualSummary residuals(const Model& model, const CondensedModel& condensed, const InterfaceState& state,
                          const std::vector<BodyFields>& fields, const std::vector<ContactNode>& contact,
                          const Comm& comm);

} // namespace ndframe

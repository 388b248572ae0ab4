#pragma once

#include <vector>

#include "ndframe/condensation/condensed_model.hpp"
#include "ndframe/coupling/coupling.hpp"
#include "ndframe/io/contact_table.hpp"
#include "ndframe/io/summary.hpp"

namespace ndframe
{

/// The displacement fields that belong to interface states.
struct BodyFields
{
  std::vector<Vector> u;            ///< per state, in the nodes' own axes, without the free motions that the coupling
                                    ///< found separately: strains have all their digits
  std::vector<Vector> displacement; ///< per state, global axes (numNodes * dim), with all motions
};

/// Interiors recovered by one multi-right-hand-side back-solve per body, (25) and (26). One entry per body; without
/// interfaces `states` holds one empty state.
std::vector<BodyFields> recoverFields(const Model& model, const CondensedModel& condensed,
                                      const std::vector<InterfaceState>& states, Ledger& ledger);

/// Every interface node with its displacements and tractions; nodes in the order of the contact matrix.
std::vector<ContactNode> contactNodes(const Model& model, const CondensedModel& condensed, const InterfaceState& state,
                                      const std::vector<BodyFields>& fields, std::size_t step);

/// True residuals of a state, from the assembled systems and not from the solvers.
ResidualSummary residuals(const Model& model, const CondensedModel& condensed, const InterfaceState& state,
                          const std::vector<BodyFields>& fields, const std::vector<ContactNode>& contact,
                          const Comm& comm);

} // namespace ndframe

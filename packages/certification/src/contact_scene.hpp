#pragma once

#include "ndframe/admissibility/admissible_traction.hpp"
#include "ndframe/condensation/condensed_model.hpp"
#include "ndframe/coupling/coupling.hpp"

namespace ndframe
{

/// The facets of all interfaces as patches, their vertices in ascending order on side 0, their nodes numbered as in the
/// contact matrix.
std::vector<ContactPatch> contactPatches(const Model& model);

/// Why the two sides of an interface are not one line to round-off (mesh files carry some digits only); empty when they
/// are.
std::string geometryCaveat(const Model& model);

/// Which tractions balance the loads of the bodies that their supports leave free (the Remark of section 5.3).
BalanceConditions balanceConditions(const Model& model, const CondensedModel& condensed,
                                    const std::vector<ContactPatch>& patches, const Comm& comm);

/// t~ = (t1 - t2) / 2 at the interface nodes: the mean of Lambda_dir(p) and the traction that body 2 is in equilibrium
/// with, Lambda_neu(p-1), or (`updated`) the one that its next problem would use, Lambda_neu(p).
InterfaceValues meanTraction(const CouplingResult& coupling, bool updated);

} // namespace ndframe

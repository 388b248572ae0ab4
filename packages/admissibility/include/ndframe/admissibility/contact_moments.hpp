#pragma once

#include "ndframe/admissibility/contact_traction.hpp"
#include "ndframe/algebra/sparse_row.hpp"
#include "ndframe/assembly/body_system.hpp"

namespace ndframe
{

/// Per patch and mode (degree + 1 values): int (u1_N - u2_N) L_k dS, N along the patch's n_c. Exact for
/// degree >= order of the displacements. displacement: per body, numNodes * dim, global axes.
Vector jumpMoments(const std::vector<const BodyModel*>& bodies, const std::vector<ContactPatch>& patches,
                   const std::vector<NodalField>& displacement, int degree);

/// The same of closing(): with the distance of the sides as they are drawn, where it counts.
Vector closingMoments(const std::vector<const BodyModel*>& bodies, const std::vector<ContactPatch>& patches,
                      const std::vector<NodalField>& displacement, int degree);

/// The nodal forces that tractions put on one body, numNodes * dim, global axes: int t_N n_c . v dS on its
/// patches, with the sign and the traction of its side.
Vector contactForces(const BodyModel& body, int bodyIndex, const std::vector<ContactPatch>& patches,
                     const SideTractions& tractions);

/// Per patch 2 int t_N w dS from the moments of w: the contact term of (42), not negative for admissible t_N, w <= 0.
Vector contactContributions(const std::vector<ContactPatch>& patches, const ContactTraction& traction, const Vector& w);
/// Adds 2 |f| unsure_f max |t| >= 2 |int t dg| for what the gap is uncertain by on a patch (GapBound::unsure).
void addUnsureGap(const std::vector<ContactPatch>& patches, const ContactTraction& traction, const Vector& unsure,
                  Vector& contributions);

/// Per patch and mode: int f L_k dS of the function with the given values at the interface nodes.
Vector nodalMoments(const std::vector<ContactPatch>& patches, const Vector& nodal, int order, int degree);

/// int psi_i v . n_c dS over the patches that a body takes part in, by interface node, with the sign with which the
/// body feels t_N: the work of nodal tractions. motion: numNodes * dim, global axes. ofBody: patchesOfBody().
SparseRow motionWork(const BodyModel& body, const Vector& motion, const std::vector<ContactPatch>& patches,
                     const std::vector<BodyPatch>& ofBody);

} // namespace ndframe

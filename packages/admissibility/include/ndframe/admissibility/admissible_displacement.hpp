#pragma once

#include <string>

#include "ndframe/admissibility/gap_bound.hpp"

namespace ndframe
{

/// u^ of (35): displacements moved at interface nodes until the Bernstein coefficients of the jump are <= the gap on
/// every patch; nothing else changes.
struct AdmissibleDisplacement
{
  std::vector<NodalField> displacement; ///< per body, global axes
  double charge = 0.0;                  ///< |u^ - u_h| in the energy norm, all bodies
  int moved = 0;                        ///< nodes moved
  std::string caveat;                   ///< a node that supports do not allow to move enough; empty when admissible
};

/// displacement: u_h per body, global axes. A penetration is divided between the two bodies by the stiffness of their
/// nodes, so that the charge is small. parts: the ranks that have parts of the bodies (BodyShare), and all cells at
/// contact; a single one where bodies are whole. Collective.
AdmissibleDisplacement admitDisplacement(const std::vector<const BodyModel*>& bodies,
                                         const std::vector<const ConstraintSet*>& constraints,
                                         const std::vector<ContactPatch>& patches, const GapBound& gap,
                                         const std::vector<NodalField>& displacement,
                                         const Comm& parts = Comm::single());

/// |to - from| in the energy norm, all bodies.
double changeInEnergy(const std::vector<const BodyModel*>& bodies, const std::vector<NodalField>& from,
                      const std::vector<NodalField>& to, const Comm& parts = Comm::single());

/// Ranks with parts of the bodies have moved the same nodes, but for round-off: all take what the first one has.
void agreeAtContact(const std::vector<const BodyModel*>& bodies, const std::vector<ContactPatch>& patches,
                    AdmissibleDisplacement& admissible, const Comm& parts);

} // namespace ndframe

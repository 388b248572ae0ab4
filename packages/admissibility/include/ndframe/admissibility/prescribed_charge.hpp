#pragma once

#include <string>

#include "ndframe/assembly/body_system.hpp"

namespace ndframe
{

/// What it costs that u_h meets prescribed displacements at its nodes only.
struct PrescribedCharge
{
  double charge = 0.0; ///< |w| in the energy norm, for a w such that u_h + w meets them everywhere
  std::string caveat;  ///< why `charge` is not a bound; empty when it is
};

/// w is supported in the cells at the sides with supports. With delta the prescribed displacement minus its interpolant
/// at the nodes of a facet f, zero at the facet's ends, and s the barycentric coordinate that is 1 on f and 0 at the
/// opposite vertex a,
///
///   w(a + s (y - a)) = s delta(y),   y on f:   zero on the cell's other edges, and grad w depends on y alone.
///
/// Its energy is integrated by Gauss rules on the pieces on which delta is a polynomial (adaptive_samples.hpp). Zero
/// without work for constant data; polynomials of the displacements' order give zero.
/// Limits: in space a delta that is not round-off is a caveat. A prescribed displacement should not jump along a side:
/// no field of finite energy meets it. parts: as in admitDisplacement(). Collective.
PrescribedCharge chargePrescribed(const BodyModel& body, const Comm& parts = Comm::single());

} // namespace ndframe

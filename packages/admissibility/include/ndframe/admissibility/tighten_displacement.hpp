#pragma once

#include "ndframe/admissibility/admissible_displacement.hpp"
#include "ndframe/assembly/constraint_set.hpp"

namespace ndframe
{

/// What the bound depends on when u^ changes. With d = s^ - K eps(u_h), v = u^ - u_h and w_v its normal jump
///
///   bound = A + R,   4 A^2 = |d|^2 + 2 <d, eps(v)> + |v|^2,   4 R^2 = |d|^2 - 2 <d, eps(v)> + |v|^2 + 4 c + 4 int t^
///   w_v.
struct BoundOfDisplacement
{
  double distance = 0.0; ///< |d|
  double contact = 0.0;  ///< c = int t^ (w_h - g) dS, an energy
  /// Per body, numNodes * dim, global axes: <d, eps(phi)> and int t^ w_phi of the nodal functions phi at the
  /// interfaces.
  std::vector<NodalField> residual, traction; ///< int t^ w_phi; both are forces
};

/// Moves u^ at the interface nodes, within w^ <= g_h, to where the bound is smallest: where contact ends within a patch
/// the nearest admissible displacement opens it under pressure, and pulling the patch's open end to the gap costs less.
/// Any u^ keeps the bound a bound, so it is enough to come near the least one: one node after the other, the normal
/// jump's Bernstein coefficients being the unknowns. Changes displacement, charge and moved of `admissible`. parts: as
/// in admitDisplacement().
void tightenDisplacement(const std::vector<const BodyModel*>& bodies,
                         const std::vector<const ConstraintSet*>& constraints, const std::vector<ContactPatch>& patches,
                         const GapBound& gap, const std::vector<NodalField>& displacement,
                         const BoundOfDisplacement& bound, AdmissibleDisplacement& admissible,
                         const Comm& parts = Comm::single());

} // namespace ndframe

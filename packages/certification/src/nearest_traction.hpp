#pragma once

#include "certificate_steps.hpp"

namespace ndframe
{

/// How admitNodal() admits tractions.
struct Admission
{
  TractionSign sign;
  const Vector& cost;
};

/// The field of a traction at the interface nodes, not solved yet.
IntermediateField fieldOf(const CertifiedScene& scene, const Vector& traction);

/// Moves an admissible traction to one whose field is nearer to the solution in energy (docs/theory.md, section 3):
///
///   min |K eps(u~(t)) - K eps(u_h)|^2 over admissible t,   t <- P(t - s [u~ - u_h] . n_c),
///
/// P: admitNodal. Every step takes one back-solve a body; there are a few at most, and none where the distance is small
/// beside interfaceMisfit(). computed: the traction that u_h is in equilibrium with; admitted: its projection; both at
/// the interface nodes; field: that of the projection, solved or not. Plane scenes.
/// Ledger: counts "traction steps".
IntermediateField nearestInEnergy(const CertifiedScene& scene, const Vector& computed, Vector admitted,
                                  IntermediateField field, const Admission& admission, Ledger& ledger);

} // namespace ndframe

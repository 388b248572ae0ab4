#pragma once

#include "ndframe/equilibrium/element_edges.hpp"
#include "ndframe/equilibrium/stress_correction.hpp"

namespace ndframe
{

/// Element equilibration (Ladeveze, Pelle and Rougeot 1991): tractions F of degree p on the edges of triangles such
/// that every cell is in balance under F and b, from the strong prolongation condition, for each cell E and nodal
/// function phi_i of the displacements of order p,
///
///   int_E (sigma^ - sigma~) grad phi_i = 0   <=>   int_dE F phi_i = int_E (sigma~ grad phi_i - b phi_i).
///
/// In terms of the correction t = F - sigma~ n:  int_dE t phi_i = - int_E (b + div sigma~) phi_i.
/// A middle node appears on one edge of a cell only: its moment follows at once. Around a vertex each cell relates the
/// moments of its two edges there, so all follow from one of them; where the ends of the fan do not fix that one
/// (closed fans, supported ends) F is nearest to the mean of the stresses sigma~ of both sides: sum over the edges of
/// |int (F - mean) phi|^2 / |e|^2 is smallest.
/// Edges of the boundary carry p exactly, along directions without support.
///
/// Limits: quality falls with the aspect ratio (effectivity 5-30 at 10).
StressCorrection equilibrateElements(const EdgeMap& edges, const BodyModel& body, const StaticData& data,
                                     const FieldInput& field);

} // namespace ndframe

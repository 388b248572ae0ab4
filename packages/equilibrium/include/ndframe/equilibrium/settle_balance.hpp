#pragma once

#include "ndframe/equilibrium/body_piece.hpp"

namespace ndframe
{

/// StressCorrection::imbalance and force become the largest of all ranks. Collective.
void agreeOnImbalance(StressCorrection& correction, const Comm& comm);

/// True when what u~ lacks of finite element equilibrium, spread over the smallest facets, could be seen in the
/// equilibrium of sigma^: a solver that stopped early, or round-off on meshes that are strongly graded and in bodies
/// that move much more than they deform. Ranks have to agree on the correction's imbalance and force. Collective.
bool needsSettling(const Mesh& mesh, const StressCorrection& correction, const Comm& comm);

/// Takes what u~ lacks of finite element equilibrium out of the balance of sigma^: where the solver stopped, and
/// eps |K| |u~| per node whatever the solver; on a small facet this is a stress that one can see.
///
/// The loads of all cells and the tractions on all facets are set to what they have to be; then every cell's wrench
/// that is left over is handed on from cell to cell, along a tree, to the supports. All changes are of the size of the
/// defects, added up along the tree. What no support takes (loads and contact traction of a free body that do not
/// balance) stays in one cell; StressCorrection::imbalance is then what cells have left.
void settleBalance(const BodyModel& body, const StaticData& data, const FieldInput& field,
                   StressCorrection& correction);

/// The same where cells are shared: every rank's connected parts hand on what they have within themselves, and then, as
/// if each were one cell, through one facet to another rank's. correction: of the piece's cells. Collective.
void settleBalance(const BodyPiece& piece, const FieldInput& field, StressCorrection& correction, const Comm& comm);

} // namespace ndframe

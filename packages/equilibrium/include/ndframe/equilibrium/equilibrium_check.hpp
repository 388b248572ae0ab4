#pragma once

#include "ndframe/equilibrium/body_piece.hpp"
#include "ndframe/equilibrium/equilibrated_stress.hpp"

namespace ndframe
{

/// Largest violations of equilibrium of sigma^, pointwise, each relative to `scale`.
struct EquilibriumDefects
{
  double divergence = 0.0; ///< |div sigma^ + b_h| times the cell's smallest height: the tractions that it amounts to
  double interior = 0.0;   ///< jump of sigma^ n between the sub-cells of a cell
  double jumps = 0.0;      ///< jump of sigma^ n between cells
  double loads = 0.0;      ///< |sigma^ n - p_h| on loaded, free and contact facets, along directions without support

  /// Largest stress, traction or load of the body; at least 1/1000 of the largest |K| |u| / h: where a body moves
  /// almost rigidly, smaller stresses are not resolved in double precision.
  double scale = 0.0;

  double largest() const; ///< of the four, relative to `scale`
};

/// Evaluates sigma^ in every cell and looks at the polynomials themselves; independent of how sigma^ was found.
EquilibriumDefects checkEquilibrium(const BodyModel& body, const StaticData& data, const FieldInput& field,
                                    const StressCorrection& correction);

/// The same where cells are shared: every rank looks at its own cells and their facets, for which it has the data of
/// the ghosts; the largest of all ranks. Collective.
EquilibriumDefects checkEquilibrium(const BodyPiece& piece, const FieldInput& field, const StressCorrection& correction,
                                    const Comm& comm);

} // namespace ndframe

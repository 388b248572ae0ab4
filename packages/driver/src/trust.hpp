#pragma once

#include <string>

#include "ndframe/driver/model.hpp"
#include "ndframe/io/summary.hpp"

namespace ndframe
{

/// Refuses scenes whose sizes, moduli, loads or gaps are so large or small that products of them leave the range of
/// floating-point numbers, where results become zero or infinite without notice. Only other units help. `deck`: the
/// model's.
void checkNumberRange(const Model& model, const Params& deck, Diagnostics& diagnostics);

/// What the true residuals (ResidualSummary) may be at most. In a Neumann-Dirichlet iteration u1 and u2 of the final
/// pairing belong to the same sweep, so the conditions of contact hold to round-off however early it stops; what the
/// stopping tolerance leaves open is only the difference of the two tractions.
struct ResidualLimits
{
  double equilibrium = 1e-7; ///< of the largest force: beyond it less than six digits are right
  double contact = 1e-8;     ///< complementarity, penetration, tension
};

/// Why a result is not what the equations ask for: the iteration did not converge, or a residual is too large. Empty
/// when it is right.
std::string distrust(const RunSummary& summary);

} // namespace ndframe

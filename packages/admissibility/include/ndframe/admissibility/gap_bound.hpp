#pragma once

#include <string>

#include "ndframe/admissibility/contact_traction.hpp"
#include "ndframe/assembly/body_system.hpp"
#include "ndframe/sampling/adaptive_samples.hpp"

namespace ndframe
{

/// A gap bounded from below by polynomials of the displacements' order on every patch, and the exact gap's moments with
/// tractions.
struct GapBound
{
  Vector bernstein;   ///< per patch, Bernstein coefficients of g_h <= g in the order of ContactPatch::nodes
  Vector moments;     ///< per patch and mode: int g L_k of the true gap
  std::string caveat; ///< why g_h <= g or the moments are not known at all; empty when they are
  Vector unsure{};    ///< per patch: what mean values of g P are uncertain by for |P| <= 1, a length; or empty: 0
};

/// The gap of the next `numPatches` patches of a list.
struct PatchGap
{
  int numPatches = 0;       ///< that have it
  SampledFunction function; ///< of the position, a length
};

/// Finds g_h and the moments of every patch, vertices in the order of ContactPatch::nodes.
///
/// g_h is the interpolant at the nodes, lowered until g_h <= g: by kappa t (1 - t) on edges of order 2 (the values at
/// the vertices stay), and by the constant that is then missing. g is enclosed on pieces of the patch
/// (adaptive_samples.hpp): it is a polynomial, bounded by its Bernstein coefficients, and an error that is bounded.
/// Gaps that are polynomials of the order are kept as they are. A gap too rough to be resolved (a kink along a curve)
/// leaves its moments uncertain.
GapBound boundGap(const std::vector<const BodyModel*>& bodies, const std::vector<ContactPatch>& patches, int degree,
                  const std::vector<PatchGap>& gaps);

} // namespace ndframe

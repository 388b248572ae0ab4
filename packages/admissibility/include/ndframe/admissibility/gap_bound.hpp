#pragma once

#include <string>

#include "ndframe/admissibility/contact_traction.hpp"
#include "ndframe/assembly/body_system.hpp"
#include "ndframe/sampling/adaptive_samples.hpp"

namespace ndframe
{

/// A gap bounded from below by polynomials of the displacements' order on every facet, and the exact gap's moments with
/// tractions.
struct GapBound
{
  Vector bernstein;   ///< per facet, Bernstein coefficients of g_h <= g in the order of JumpCoefficients
  Vector moments;     ///< per facet and mode: int g L_k of the true gap
  std::string caveat; ///< why g_h <= g or the moments are not known at all; empty when they are
  Vector unsure{};    ///< per facet: what mean values of g P are uncertain by for |P| <= 1, a length; or empty: 0
};

/// The gap of the next `numFacets` facets of a list.
struct FacetGap
{
  int numFacets = 0;        ///< that have it
  SampledFunction function; ///< of the position, a length
};

/// Finds g_h and the moments of every facet, vertices in the order of ContactFacet::nodes.
///
/// g_h is the interpolant at the nodes, lowered until g_h <= g: by kappa t (1 - t) on edges of order 2 (the values at
/// the vertices stay), and by the constant that is then missing. g is enclosed on pieces of the facet
/// (adaptive_samples.hpp): it is a polynomial, bounded by its Bernstein coefficients, and an error that is bounded.
/// Gaps that are polynomials of the order are kept as they are. A gap too rough to be resolved (a kink along a curve)
/// leaves its moments uncertain.
GapBound boundGap(const std::vector<const BodyModel*>& bodies, const std::vector<ContactFacet>& facets, int degree,
                  const std::vector<FacetGap>& gaps);

} // namespace ndframe

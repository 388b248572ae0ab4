#pragma once

#include <functional>
#include <string>

#include "ndframe/assembly/body_system.hpp"
#include "ndframe/recovery/contact_traction.hpp"

namespace ndframe
{

/// A gap bounded from below by polynomials of the displacements' order on every facet, and the exact gap's moments with
/// tractions.
struct GapBound
{
  Vector bernstein; ///< per facet, order + 1 Bernstein coefficients of g_h <= g
  Vector moments;   ///< per facet, degree + 1: int g L_k of the true gap
  std::string
      caveat; ///< why g_h <= g or the moments are not certain (a gap too rough to be resolved); empty when they are
};

/// The gap on a facet (its number in the list) at a point of the Dirichlet body; refuses values that are not finite.
using FacetGap = std::function<double(int facet, const double* point)>;

/// Finds g_h and the moments of every facet, vertices in the order of ContactFacet::nodes.
///
/// g_h is the interpolant at the nodes, lowered until g_h <= g: by kappa t (1 - t) for order 2 (the values at the
/// vertices stay), by a constant for order 1. g is resolved by Gauss rules on pieces of the facet
/// (adaptive_samples.hpp); what must not be negative is bounded by its Bernstein coefficients on every piece. Gaps that
/// are polynomials of the order are kept as they are.
GapBound boundGap(const std::vector<const BodyModel*>& bodies, const std::vector<ContactFacet>& facets, int degree,
                  const FacetGap& gap);

} // namespace ndframe

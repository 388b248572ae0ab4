#pragma once

#include <vector>

#include "ndframe/algebra/comm.hpp"
#include "ndframe/recovery/contact_traction.hpp"

namespace ndframe
{

/// A constitutive relation error (39) and its parts, in the energy norm sqrt(int K eps : eps).
struct ErrorMeasure
{
  std::vector<Vector> cells; ///< (42) squared, per body and cell; a facet's contact term is shared by its two cells
  double elements = 0.0;     ///< D = |sigma^ - K eps(u^)|
  double contact = 0.0;      ///< 2 int t^ (w^ - g) dS, an energy; below zero only where w^ penetrates (Paper mode)
  double projection = 0.0;   ///< |u^ - u_h|
  double oscillation = 0.0;  ///< loads and prescribed displacements that the polynomials do not carry

  /// sqrt(D^2 + contact) + oscillation + projection: what |u - u_h| and |sigma - sigma^| cannot exceed
  /// (docs/theory.md).
  double absolute() const;
  /// sqrt(D^2/4 + contact/2) + oscillation: what the mean of sigma^ and K eps(u^) cannot miss the true stress by.
  double meanStress() const;
};

/// Assembles a measure from the cells' squared distances (cellDistances, per body) and the facets' contact terms
/// (contactContributions; empty without contact).
ErrorMeasure assembleMeasure(std::vector<Vector> distances, const std::vector<ContactFacet>& facets,
                             const Vector& contact);

/// sqrt of the contributions of one body's cells; a contribution below zero (round-off, Paper mode) gives zero.
Vector contributions(const Vector& squared);

/// Square root of the sum of all entries.
double totalOf(const std::vector<Vector>& squared);

} // namespace ndframe

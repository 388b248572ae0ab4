#pragma once

#include <vector>

#include "ndframe/admissibility/contact_traction.hpp"
#include "ndframe/algebra/comm.hpp"
#include "ndframe/algebra/field.hpp"

namespace ndframe
{

/// A constitutive relation error (39) and its parts, in the energy norm sqrt(int K eps : eps).
struct ErrorMeasure
{
  /// (42) squared, per body and cell: (D_E + osc_E)^2; a patch's contact term is shared by its two cells.
  std::vector<CellValues> cells;
  double elements = 0.0;    ///< D = |sigma^ - K eps(u^)|
  double contact = 0.0;     ///< 2 int t^ (w^ - g) dS, an energy; below zero only where w^ penetrates (Paper mode)
  double projection = 0.0;  ///< |u^ - u_h|
  double aside = 0.0;       ///< A = |K eps(u_h) - s_m|, s_m the mean of sigma^ and K eps(u^); D/2 where u_h = u^
  double oscillation = 0.0; ///< osc: loads that the polynomials do not carry
  double prescribed = 0.0;  ///< |l|: prescribed displacements that the polynomials do not carry
  double widened = 0.0;     ///< sqrt(sum (D_E + osc_E)^2): D, widened by the oscillation

  /// eta = sqrt(D^2 + contact) + projection + osc + |l|: (39) as the paper combines it.
  double sum() const;
  /// R + |l|, R^2 = D^2/4 + contact/2 + osc B, B = widened/2 + sqrt(widened^2/4 + contact/2): what the mean of sigma^
  /// and K eps(u^) cannot miss the true stress by.
  double meanStress() const;
  /// max(A, D/2) + R + |l|: what |u - u_h| and |sigma - sigma^| cannot exceed. Never above eta (docs/theory.md).
  double bound() const;

private:
  double radius() const;
};

/// Assembles a measure from the cells' squared distances (cellDistances, per body) and the patches' contact terms
/// (contactContributions; empty without contact) for u^ = u_h. oscillation: of the cells' data, squared, per body;
/// empty where all data are carried. parts: the ranks that have cells of their own, and zeros at others'; a single one
/// where each has all. Collective.
ErrorMeasure assembleMeasure(std::vector<CellValues> distances, const std::vector<ContactPatch>& patches,
                             const Vector& contact, const std::vector<CellValues>& oscillation = {},
                             const Comm& parts = Comm::single());

/// sqrt of the contributions of one body's cells; a contribution below zero (round-off, Paper mode) gives zero.
CellValues contributions(const Vector& squared);

/// Square root of the sum of all entries, of all parts. Collective.
double totalOf(const std::vector<CellValues>& squared, const Comm& parts = Comm::single());

} // namespace ndframe

#pragma once

#include <optional>

#include "ndframe/algebra/sparse_columns.hpp"
#include "symmetric_rows.hpp"

namespace ndframe
{

/// min 1/2 x^T M x - f^T x  subject to  x <= 0,  W^T x = r;  M positive definite, n x n, banded where contact is along
/// chains of edges.
struct BandedProgram
{
  SymmetricRows M;
  Vector f;
  SparseColumns W; ///< n x conditions, in comparable units; columns may depend on each other or vanish
  Vector r;
  double force = 0.0; ///< conditions also count as met to round-off of this; 0: of their own terms only
};

/// The minimum; none when no point is admissible.
///
/// Block principal pivoting (Judice and Pires 1994; Kim and Park 2011) for the bounds: every step solves for all
/// entries not at their bound and exchanges those of the wrong sign; when that does not reduce their number three times
/// in a row, those that are wrong by a tenth of the largest, as smaller ones often follow them (where f = 0 beside a
/// region that is pressed, signs are those of what decays into it); after 50 such steps in a row only the last one is
/// exchanged (Murty's rule, finite). The conditions enter through their multipliers with
/// a vanishing proximal term, W^T x - e lambda = r - e lambda_old, so that every step is well posed even where too few
/// entries are free to meet them; lambda_old is then moved until W^T x = r. Where M falls into blocks (one interface
/// each), so do its factors, and the conditions' multipliers come from a sparse matrix: time grows with the number of
/// blocks.
///
/// KKT conditions hold to 1e-12 relative, bounds exactly. Each step costs one factorisation: of a band, or of the
/// entries alone where it would be wide.
std::optional<Vector> minimise(const BandedProgram& program);

} // namespace ndframe

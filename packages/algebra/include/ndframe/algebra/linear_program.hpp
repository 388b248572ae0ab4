#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "ndframe/algebra/comm.hpp"
#include "ndframe/algebra/sparse_row.hpp"

namespace ndframe
{

inline constexpr double unbounded = std::numeric_limits<double>::infinity(); ///< as a bound: none

/// maximise c . x  subject to  lower <= x <= upper  and  rowLower <= A x <= rowUpper.
struct LinearProgram
{
  Vector cost, /**< c */ lower, /**< bounds of x, as `upper` */ upper; ///< c and the bounds of x; +-unbounded for none
  std::vector<SparseRow> rows;                                         ///< of A, each column at most once
  Vector rowLower, /**< per row; -unbounded for none */ rowUpper;      ///< per row; unbounded for none
};

/// Solves it by COIN-OR Clp's primal simplex after its crash ("sprint"): a vertex to round-off. Bounds, rows and signs
/// of reduced costs are judged to 1e-9: entries and costs should be of the order of 1. Nothing when there is no
/// solution: no x meets the rows, or c . x has no bound.
std::optional<Vector> solve(const LinearProgram& program);

} // namespace ndframe

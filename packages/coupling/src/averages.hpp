#pragma once

#include "ndframe/algebra/sparse_row.hpp"

namespace ndframe
{

/// E = (B W B^T)^-1 B W, so that E B^T = 1: averages weighted by W of the entries of v that B combines.
struct Averages
{
  std::vector<SparseRow> rows;
  Vector gramDiagonal; ///< of B W B^T
};

/// B by rows, which are independent of each other; weights: W, positive, one an entry. B W B^T has a dense block for
/// rows that share entries, a few where interfaces meet; cost: the cube of these.
Averages averagesOf(const std::vector<SparseRow>& B, const Vector& weights);

} // namespace ndframe

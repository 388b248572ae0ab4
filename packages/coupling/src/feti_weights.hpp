#pragma once

#include "network.hpp"

namespace ndframe
{

/// B_D = (B D^-1 B^T)^-1 B D^-1: shares an opening out to the entries of v by their softness, so that B_D B^T = 1.
struct WeightedJump
{
  std::vector<SparseRow> rows;
  Vector gramDiagonal; ///< of B D^-1 B^T
};

/// rows: the unknowns that B consists of, none of which follows from others; weights: D, positive. B D^-1 B^T has a
/// dense block for unknowns that share nodes, a few where interfaces meet; cost: the cube of these.
WeightedJump weightedJump(const Network& network, const std::vector<int>& rows, const Vector& weights);

} // namespace ndframe

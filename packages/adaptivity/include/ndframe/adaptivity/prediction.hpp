#pragma once

#include <cstdint>
#include <vector>

#include "ndframe/algebra/comm.hpp"

namespace ndframe
{

/// How the contribution of a cell falls when it is refined.
struct CellDecay
{
  double logSquared; ///< log2 eta_K^2; minus infinity without a contribution
  double exponent;   ///< p + 1 where the solution is smooth, lambda where it is like r^lambda around a vertex
};

/// What the best refinement of plane meshes comes to.
struct Prediction
{
  double level = 0.0;        ///< log2 tau^2: every new cell contributes tau^2
  std::int64_t numCells = 0; ///< without what conformity adds
  double error = 0.0;        ///< that is left, an energy norm
};

/// The refinement with the fewest cells that leaves the error `target` (an energy norm), for displacements of degree p.
///
/// A smooth cell in 2^n parts leaves 2^(-p n) eta_K^2. Around a vertex with u ~ r^lambda parts at the distance r of
/// size h contribute ~ h^(2p+2) r^(2 lambda - 2 - 2p); graded so that all contribute the same, there are
/// (p + 1) / lambda times as many. So N_K = (p + 1) / lambda (eta_K^2 / tau^2)^(1 / (p + 1)) parts leave N_K tau^2.
Prediction predictRefinement(const std::vector<std::vector<CellDecay>>& cells, double target, int degree);

/// How often a smooth cell is to be halved to reach tau^2, rounded.
int smoothHalvings(double logSquared, double level, int degree);

} // namespace ndframe

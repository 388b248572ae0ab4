#pragma once

#include <cstdint>
#include <vector>

#include "ndframe/adaptivity/error_decay.hpp"

namespace ndframe
{

/// How the contribution of a cell falls when it is refined.
struct CellDecay
{
  double logSquared; ///< log2 eta_K^2; minus infinity without a contribution
  double exponent;   ///< p + 1 where the solution is smooth, lambda where it is like r^lambda around a corner or edge
};

/// What the best refinement of meshes comes to.
struct Prediction
{
  double level = 0.0;        ///< log2 tau^2: every new cell contributes tau^2
  std::int64_t numCells = 0; ///< without what conformity adds
  double error = 0.0;        ///< that is left, an energy norm
};

/// The refinement with the fewest cells that leaves the error `target` (an energy norm), for displacements of degree p.
///
/// A smooth cell in 2^n parts leaves 2^(-2 p n / dim) eta_K^2. Around a place with u ~ r^lambda parts at the distance r
/// of size h contribute ~ h^(2p+dim) r^(2 lambda - 2 - 2p); graded so that all contribute the same, N_K parts leave
/// N_K tau^2. With q = eta_K^2 / tau^2:
///   plane, a corner: N_K = (p + 1) / lambda q^(1 / (p + 1));
///   space, an edge:  the parts of the shells H 2^(-j-1) < r < H 2^(-j) for j = 0, ..., log2(q) / (2 lambda + 1), where
///                    h reaches r. There are 3/4 q^(1/s) 2^(j (2 (1 + p - lambda) / s - 2)) of them, s = (2p + 3) / 3:
///                    more and more towards the edge if lambda < p / 3.
Prediction predictRefinement(const std::vector<std::vector<CellDecay>>& cells, double target, ErrorDecay decay);

/// How often a smooth cell is to be halved to reach tau^2, rounded.
int smoothHalvings(double logSquared, double level, ErrorDecay decay);

} // namespace ndframe

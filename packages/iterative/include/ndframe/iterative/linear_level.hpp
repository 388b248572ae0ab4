#pragma once

#include <array>
#include <memory>
#include <vector>

#include "ndframe/algebra/rank_problem.hpp"

namespace ndframe
{

/// Linear functions in this rank's nodes of second-order elements: u = P c with c at the vertices, components in the
/// nodes' own axes Q (rows = axes). A vertex has u = c, the middle of an edge
///
///   u_m = Q_m (Q_a^T c_a + Q_b^T c_b) / 2.
struct LinearInterpolation
{
  LinearInterpolation() = default;                                   ///< of nothing
  LinearInterpolation(const RankProblem& problem, const Comm& comm); ///< problem: with `ends`. Collective

  /// The dim x dim blocks of both ends of an own node; null where each is half the identity.
  const double* blocks(int node) const
  {
    const int place = turned.empty() ? -1 : turned[std::size_t(node)];
    return place < 0 ? nullptr : turnedBlocks.data() + std::size_t(place) * 2 * std::size_t(dim) * std::size_t(dim);
  }

  int dim = 0; ///< of space
  /// Own vertices, and those that own nodes interpolate. A vertex has the number of its node; there are as many as the
  /// largest one says.
  IndexMap vertices;
  std::vector<std::array<int, 2>> ends; ///< per own node, held numbers of vertices; a vertex is both
  std::vector<int> turned;              ///< per own node its place in turnedBlocks, -1: none; empty: none at all
  std::vector<double> turnedBlocks;     ///< at each place Q_m Q_a^T / 2 and Q_m Q_b^T / 2, row-major
};

/// The coarse level of a body: P^T K P on the interior dofs of both levels, with all that a solver wants to know.
struct LinearLevel
{
  LinearLevel(const RankProblem& problem, const Comm& comm); ///< Collective. A rank has the rows of its vertices

  LinearInterpolation interpolation; ///< P
  BlockMatrix matrix;                ///< P^T K P, K masked to interior dofs; blocks by vertex
  RankProblem problem;               ///< of `matrix`: this must stay where it is

  LinearLevel(const LinearLevel&) = delete;
  LinearLevel& operator=(const LinearLevel&) = delete;
};

} // namespace ndframe

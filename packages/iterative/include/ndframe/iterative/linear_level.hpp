#pragma once

#include <array>
#include <memory>
#include <vector>

#include "ndframe/algebra/linear_solver.hpp"

namespace ndframe
{

/// Linear functions in the nodes of second-order elements: u = P c with c at the vertices, components in the nodes' own
/// axes Q (rows = axes). A vertex has u = c, the middle of an edge
///
///   u_m = Q_m (Q_a^T c_a + Q_b^T c_b) / 2.
struct LinearInterpolation
{
  LinearInterpolation(const EdgeNodes& nodes, int dim); ///< nodes: with `ends`; dim: of space

  /// The dim x dim blocks of both ends; null where each is half the identity.
  const double* blocks(int node) const
  {
    const int place = turned.empty() ? -1 : turned[std::size_t(node)];
    return place < 0 ? nullptr : turnedBlocks.data() + std::size_t(place) * 2 * std::size_t(dim) * std::size_t(dim);
  }

  int dim;                              ///< of space
  std::vector<std::array<int, 2>> ends; ///< per node, numbers of vertices among vertices; a vertex is both
  std::vector<int> vertices;            ///< their nodes
  std::vector<int> turned;              ///< per node its place in turnedBlocks, -1: none; empty: none at all
  std::vector<double> turnedBlocks;     ///< at each place Q_m Q_a^T / 2 and Q_m Q_b^T / 2, row-major
};

/// The coarse level of a body: P^T K P on the interior dofs of both levels, with all that a solver wants to know.
struct LinearLevel
{
  /// Collective. A rank has the rows of its vertices. The problem's near null space and points may have rows of
  /// vertices only.
  LinearLevel(const SolverProblem& problem, const Comm& comm);

  LinearInterpolation interpolation; ///< P
  BlockMatrix matrix;                ///< P^T K P, K masked to interior dofs; blocks by vertex
  SolverProblem problem;             ///< of `matrix`: this must stay where it is

  LinearLevel(const LinearLevel&) = delete;
  LinearLevel& operator=(const LinearLevel&) = delete;
};

} // namespace ndframe

#pragma once

#include <array>
#include <vector>

#include "ndframe/algebra/linear_solver.hpp"

namespace ndframe
{

/// A body's matrix with what iterations want to know of it where this rank holds something: at its own nodes and at the
/// ghosts of its rows, numbered as `matrix->nodes` does. Nothing has the size of all nodes; kept dofs, which are few,
/// are listed on every rank. The matrix must outlive what is made from it.
struct RankProblem
{
  using Global = IndexMap::Global;

  const BlockMatrix* matrix = nullptr; ///< K, not owned
  std::vector<DofRole> roles;          ///< one per dof of a held node
  /// The Kept dofs of all ranks, in the order of the condensed system: dim for each of all nodes; -1 where one is none.
  std::vector<Global> kept;
  std::vector<std::array<Global, 2>> keptEnds; ///< per kept dof the ends of its node's edge, by numbers of all ranks
  std::vector<int> holding; ///< kept dofs, by their places there, that hold the body as FreeMotions::held do
  bool isHeld = true;       ///< false: kept and fixed dofs together leave it a motion
  /// Per own node the ends of the edge that it is the middle of, held nodes; a vertex is both of its ends. Empty: all
  /// nodes of all ranks are vertices.
  std::vector<std::array<int, 2>> ends;
  std::vector<int> turned;   ///< of own nodes and their ends those whose components have axes of their own, ascending
  std::vector<double> axes;  ///< dim x dim for each of them, row k = axis of component k
  DenseMatrix nearNullSpace; ///< rigid motions in the dofs' own frames, one a column; rows: dofs of own vertices
  std::vector<double> nodePoints; ///< coordinates of own vertices, dim for each
  BodyOutline outline;            ///< as of the SolverProblem
  /// Of D^-1 K on the dofs that are not fixed or kept, D the diagonal, about; 0: unknown. Used by multigrid.
  double largestEigenvalue = 0.0;

  /// The role of component i of a held node.
  DofRole role(int node, int i) const { return roles[std::size_t(node) * std::size_t(matrix->dim) + std::size_t(i)]; }
  bool isVertex(int own) const { return ends.empty() || ends[std::size_t(own)][0] == ends[std::size_t(own)][1]; }
  /// This rank's number of a kept dof among held ones, -1: it holds none of the node, or there is none.
  int held(Global dof) const
  {
    const int node = dof < 0 ? -1 : matrix->nodes.local(dof / matrix->dim);
    return node < 0 ? -1 : node * matrix->dim + int(dof % matrix->dim);
  }
};

} // namespace ndframe

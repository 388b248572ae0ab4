#pragma once

#include <array>
#include <vector>

#include "ndframe/algebra/dense.hpp"

namespace ndframe
{

/// What flows between two cells, or into a support, for potentials p_0, p_1 (p_1 = 0 at a support):
/// conductance * through through^T (p_0 - p_1), a wrench; between cells `through` is one.
struct FlowLink
{
  std::array<int, 2> cell; ///< the second is -1 at a support
  double conductance;
  DenseMatrix through; ///< 6 x r; empty between cells
};

/// sum += factor columns columns^T, 6 x 6; columns of the sum are `stride` apart.
void addSquare(const DenseMatrix& columns, double factor, double* sum, int stride);

/// Orthonormal motions of all cells together that no support resists: 6 x their number.
DenseMatrix freeMotions(const std::vector<FlowLink>& links);

/// Potentials, 6 x cells, of flows that bring every cell what it needs (6 x cells). free: freeMotions(); nothing that
/// is needed in all works on them. Cells hang together.
DenseMatrix potentials(const std::vector<FlowLink>& links, const DenseMatrix& free, DenseMatrix needed);

} // namespace ndframe

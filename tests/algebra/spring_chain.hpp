#pragma once

#include "ndframe/algebra/dense.hpp"

namespace ndframe::test
{

/// The matrix of unit springs between neighbours of a chain of n nodes; ground: of a spring that holds the first one.
/// Without it constants are the null space.
inline DenseMatrix springChain(int n, double ground = 0.0)
{
  DenseMatrix A(n, n);
  A(0, 0) = ground;
  for (int i = 0; i + 1 < n; ++i) {
    A(i, i) += 1.0;
    A(i + 1, i + 1) += 1.0;
    A(i, i + 1) = A(i + 1, i) = -1.0;
  }
  return A;
}

} // namespace ndframe::test

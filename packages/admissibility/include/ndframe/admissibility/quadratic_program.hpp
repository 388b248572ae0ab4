#pragma once

#include <optional>

#include "ndframe/algebra/dense.hpp"

namespace ndframe
{

/// min 1/2 x^T H x + h^T x  subject to  B x <= b,  H symmetric positive definite (conditions E x = 0 are best met by
/// writing x in a basis of their null space).
struct QuadraticProgram
{
  DenseMatrix H; ///< n x n
  Vector h;      ///< n
  DenseMatrix B; ///< m x n; rows may depend on each other, repeat or vanish
  Vector b;      ///< m
};

/// Its solution.
struct QuadraticMinimum
{
  Vector x;           ///< n entries
  Vector multipliers; ///< of B x <= b:  H x + h + B^T mu = 0,  mu >= 0,  mu (B x - b) = 0
};

/// The minimum, exactly, in finitely many steps: the dual active set method of Goldfarb and Idnani (1983) in the
/// coordinates L^T x in which H is the identity. Needs no feasible start and meets no cycles at degenerate vertices.
/// Inequalities hold to 1e-13 relative to x itself, however far away the free minimum lies. Nothing when no x satisfies
/// the inequalities. For n up to about 20 and any m: some n * (n^2 + n m) operations.
std::optional<QuadraticMinimum> minimise(const QuadraticProgram& program);

} // namespace ndframe

#pragma once

#include <vector>

#include "ndframe/algebra/comm.hpp"
#include "ndframe/algebra/dense.hpp"

namespace ndframe
{

/// A start for conjugate gradients from earlier solutions of the same system A: their A-orthonormal basis X gives the
/// best combination for b, X X^T b (Fischer 1998). Right-hand sides that follow each other, as those of sweeps do, need
/// fewer iterations from one to the next. Vectors have the dofs of this rank's nodes.
///
/// Keeps at most `mostSolutions` vectors; then begins again.
class RecycledSolutions
{
public:
  explicit RecycledSolutions(const Comm& comm) : comm_(comm) {}

  /// X X^T b. Collective.
  Vector start(const Vector& b) const;

  /// x = A^-1 b - start(b), to the tolerance of a solve, and A x. Collective.
  void add(const Vector& x, const Vector& Ax);

private:
  static constexpr std::size_t mostSolutions = 24;
  Comm comm_;
  std::vector<Vector> basis_;
};

} // namespace ndframe

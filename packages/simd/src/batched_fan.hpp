#pragma once

#include <array>

#include "ndframe/algebra/dense.hpp"

namespace ndframe
{

/// A facet at the end of a fan, seen from the star's vertex.
struct FanEnd
{
  std::array<double, 2> spoke{}; ///< from the vertex to the other end
  int freeDirections = 2;        ///< in which no support holds it: the traction is given
  std::array<std::array<double, 2>, 2> direction{{{1.0, 0.0}, {0.0, 1.0}}};
  Vector given; ///< fields x modes x 2: moments of the outward traction, L_k counted from the vertex
};

/// Least energy  x^T A x / 2 + g^T x  of a fan over its border unknowns x = (w, s_0, s_last) (StarBatch::border) such
/// that the tractions on its ends are as given.
struct FanProblem
{
  int degree = 0;
  double arm = 0.0; ///< StarTables::arm
  FanEnd first, last;
  DenseMatrix energy;   ///< A, N x N
  DenseMatrix gradient; ///< g, N x fields
  DenseMatrix offset;   ///< 3 x fields: wrench through the last spoke without the unknown one
};

struct FanSolution
{
  DenseMatrix x; ///< N x fields
  Vector defect; ///< per field: largest moment of a traction that cannot be as given
};

/// Supports in any directions; conditions that depend on each other (both ends free) are recognised by their rank.
FanSolution solveFan(const FanProblem& fan);

} // namespace ndframe

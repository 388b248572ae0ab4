#pragma once

#include <vector>

#include "mumps_instance.hpp"
#include "ndframe/algebra/solver_problem.hpp"

namespace ndframe
{

/// This rank's rows of the lower triangle on the free dofs, numbered from one.
struct LowerEntries
{
  std::vector<MUMPS_INT> rows;
  std::vector<MUMPS_INT> cols;
  std::vector<double> values;
};

LowerEntries ownLowerEntries(const BlockMatrix& K, const FreeDofs& free);

/// MUMPS wants, for every variable, its position.
std::vector<MUMPS_INT> positionsFromOne(const std::vector<int>& order);

/// A symmetric n x n matrix given by rows, of which the lower triangle counts: itself, and its product with a vector.
DenseMatrix matrixOfLowerRows(const Vector& rows, int n);
Vector multiplyLowerRows(const Vector& rows, const Vector& x);

} // namespace ndframe

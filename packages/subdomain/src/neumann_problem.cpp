#include "ndframe/subdomain/neumann_problem.hpp"

#include <cmath>
#include <utility>

namespace ndframe
{
namespace
{

/// The row of largest norm, with its norm; norm 0 when all rows vanish.
std::pair<int, double> largestRow(const DenseMatrix& A)
{
  std::pair<int, double> largest{0, 0.0};
  for (int i = 0; i < A.rows(); ++i) {
    double square = 0.0;
    for (int j = 0; j < A.cols(); ++j)
      square += A(i, j) * A(i, j);
    if (square > largest.second)
      largest = {i, square};
  }
  return {largest.first, std::sqrt(largest.second)};
}

/// Removes the direction of one row from all rows.
void removeDirection(DenseMatrix& A, int row, double length)
{
  Vector direction;
  for (int j = 0; j < A.cols(); ++j)
    direction.push_back(A(row, j) / length);
  for (int i = 0; i < A.rows(); ++i) {
    double along = 0.0;
    for (int j = 0; j < A.cols(); ++j)
      along += A(i, j) * direction[std::size_t(j)];
    for (int j = 0; j < A.cols(); ++j)
      A(i, j) -= along * direction[std::size_t(j)];
  }
}

} // namespace

NeumannProblem::NeumannProblem(const SymmetricOperator& S, Vector g, const DenseMatrix& rigidTraces, Ledger& ledger)
    : g_(std::move(g)), inverse_(S.inverseOn(freeWhenHeld(rigidTraces), 0.0)), ledger_(ledger)
{
  ledger_.count("interface factorisations");
}

Vector NeumannProblem::solve(const Vector& contactForce) const
{
  Vector force = g_;
  for (std::size_t i = 0; i < force.size(); ++i)
    force[i] -= contactForce[i];
  ledger_.count("Neumann solves");
  return inverse_->solve(force);
}

std::vector<char> freeWhenHeld(const DenseMatrix& rigidTraces)
{
  std::vector<char> isFree(std::size_t(rigidTraces.rows()), 1);
  DenseMatrix rest = rigidTraces;
  for (int m = 0; m < rigidTraces.cols(); ++m) {
    const auto [row, length] = largestRow(rest);
    if (length == 0.0)
      break; // motions without trace: nothing on the interface stops them
    isFree[std::size_t(row)] = 0;
    removeDirection(rest, row, length);
  }
  return isFree;
}

} // namespace ndframe

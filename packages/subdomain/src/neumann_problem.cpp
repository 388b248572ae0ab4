#include "ndframe/subdomain/neumann_problem.hpp"

#include <utility>

#include "ndframe/algebra/pivot_rows.hpp"

namespace ndframe
{

NeumannProblem::NeumannProblem(const SymmetricOperator& S, Vector g, const DenseMatrix& rigidTraces, Ledger& ledger,
                               const std::vector<char>& held)
    : g_(std::move(g)), inverse_(S.inverseOn(freeWhenHeld(rigidTraces, held), 0.0)), ledger_(ledger)
{
  ledger_.count("interface factorisations");
}

Vector NeumannProblem::solve(const Vector& contactForce) const
{
  ledger_.count("Neumann solves");
  return inverse_->solve(difference(g_, contactForce));
}

std::vector<char> freeWhenHeld(const DenseMatrix& rigidTraces, const std::vector<char>& held)
{
  std::vector<char> isFree(std::size_t(rigidTraces.rows()), 1);
  for (const int row : pivotRows(rigidTraces)) // motions without trace: nothing on the interface stops them
    isFree[std::size_t(row)] = 0;
  for (std::size_t i = 0; i < held.size(); ++i)
    if (held[i])
      isFree[i] = 0;
  return isFree;
}

} // namespace ndframe

#include "ndframe/subdomain/neumann_problem.hpp"

#include <utility>

namespace ndframe
{

NeumannProblem::NeumannProblem(const SymmetricOperator& S, Vector g, Ledger& ledger)
    : g_(std::move(g)), inverse_(S.inverseOn(std::vector<char>(std::size_t(S.size()), 1), 0.0)), ledger_(ledger)
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

} // namespace ndframe

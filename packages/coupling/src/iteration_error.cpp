#include "iteration_error.hpp"

#include <algorithm>
#include <cmath>

namespace ndframe
{

IterationError::IterationError(const InterfaceSystem& system, const RoleSystem& dirichlet, const RoleSystem& neumann,
                               const NeumannProblem& neumannProblem, Ledger& ledger)
    : system_(system), dirichletBalance_(system, dirichlet.freeMotions), neumannBalance_(system, neumann.freeMotions),
      dirichletInverse_(dirichlet.S->inverseOn(freeWhenHeld(dirichlet.freeMotions), 0.0)), neumann_(neumannProblem)
{
  ledger.count("interface factorisations");
}

double IterationError::measure(const InterfaceState& state) const
{
  UnknownValues half = state.forceDirichlet;
  for (std::size_t i = 0; i < half.size(); ++i)
    half[i] = 0.5 * (half[i] - state.forceNeumann[i]);
  const UnknownValues onDirichlet = dirichletBalance_.balanced(half), onNeumann = neumannBalance_.balanced(half);
  const double dirichletEnergy = dot(onDirichlet, dirichletInverse_->solve(onDirichlet));

  UnknownValues mean = state.forceNeumann;
  for (std::size_t i = 0; i < mean.size(); ++i)
    mean[i] += onNeumann[i];
  // Under Lambda_neu, less that under the mean: S_N^-1 r_N.
  const Vector change = difference(state.strainedNeumann, system_.withObstacles(ofUnknowns(neumann_.solve(mean))));
  const double neumannEnergy = std::max(dot(onNeumann, change), 0.0); // below 0 by round-off of a difference
  return std::sqrt(dirichletEnergy + neumannEnergy);
}

} // namespace ndframe

#include "convergence_advice.hpp"

#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace ndframe
{

ConvergenceAdvice adviceFor(const RelaxationController& relaxation, Roles roles)
{
  return {relaxation.givenTheta().has_value(), relaxation.needsSpectrum(), roles == Roles::Automatic};
}

std::string ConvergenceAdvice::text(bool overshoots) const
{
  std::vector<std::string> ways;
  if (givenTheta)
    ways.emplace_back(overshoots ? "a smaller Theta" : "a larger Theta");
  if (!automaticTheta)
    ways.emplace_back("Coupling/Relaxation/Type = Automatic");
  if (!automaticRoles)
    ways.emplace_back("Coupling/Dirichlet Body = Automatic");
  const std::string last = "Coupling/Type = Monolithic may help";
  return ways.empty() ? last : fmt::format("{} or {}", fmt::join(ways, ", "), last);
}

} // namespace ndframe

#pragma once

#include <string>

#include "ndframe/coupling/coupling.hpp"

namespace ndframe
{

/// What may help a Neumann-Dirichlet iteration that gets nowhere: of the ways that there are, those that were not gone.
struct ConvergenceAdvice
{
  bool givenTheta;     ///< the deck names the factor
  bool automaticTheta; ///< the factor comes from the spectrum
  bool automaticRoles;

  /// "a smaller Theta, ... or Coupling/Type = Monolithic may help". Tractions that overshoot turn from sweep to sweep;
  /// when they keep their direction, the steps are too short.
  std::string text(bool overshoots) const;
};

ConvergenceAdvice adviceFor(const RelaxationController& relaxation, Roles roles);

} // namespace ndframe

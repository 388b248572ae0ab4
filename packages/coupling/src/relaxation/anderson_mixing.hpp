#pragma once

#include <deque>

#include "ndframe/coupling/relaxation_controller.hpp"

namespace ndframe
{

/// Anderson's mixing of the sweeps' tractions (Anderson 1965; Walker and Ni 2011). With r_p = Lambda_dir(p) -
/// Lambda_neu(p-1) and the differences dr, dL of the residuals and tractions of the last sweeps,
///
///   gamma = argmin |r_p - dr gamma|,   Lambda_neu(p) = Lambda_neu(p-1) + theta r_p - (dL + theta dr) gamma,
///
/// which for a linear iteration is GMRES over as many sweeps as are remembered. The new traction is a sum of earlier
/// ones with weights that add up to one, so what all of them balance it balances, too.
///
/// Differences of sweeps with other statuses mislead. Where the residual grows all are forgotten; when that has
/// happened often, they stay so, and the steps are those of the constant theta.
class AndersonMixing
{
public:
  void start();

  /// Lambda_neu(p). dirichlet: Lambda_dir(p), neumann: Lambda_neu(p-1).
  InterfaceValues next(const InterfaceValues& dirichlet, const InterfaceValues& neumann, double theta);

  /// As RelaxationController has it.
  RelaxationMemory memory() const;
  bool recall(const RelaxationMemory& memory); ///< the same

private:
  void remember(const Vector& residual, const Vector& traction);

  std::deque<Vector> residualChanges_, tractionChanges_; ///< the latest last
  Vector residual_, traction_;                           ///< of the sweep before; empty in the first
  int restarts_ = 0;
};

} // namespace ndframe

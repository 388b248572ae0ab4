#pragma once

#include <string>
#include <vector>

#include "ndframe/coupling/coupling.hpp"

namespace ndframe
{

/// The paper's criterion: stop when eps_tau falls below the tolerance, or after `Maximum Sweeps`.
class Stopping
{
public:
  Stopping(double tolerance, int maximumSweeps) : tolerance_(tolerance), maximumSweeps_(maximumSweeps) {}

  /// eps_tau = |Lambda_dir - Lambda_neu| / (1/2 |Lambda_dir + Lambda_neu|); 0 when both vanish.
  static double measure(const Vector& dirichlet, const Vector& neumann);

  /// True when the iteration must end after the sweeps in the history; fills in the verdict. agree: the contact forces
  /// on the two sides cannot come closer.
  bool ends(CouplingResult& result, bool agree) const;

  static ListSpec spec();

private:
  double tolerance_;
  int maximumSweeps_;
};

} // namespace ndframe

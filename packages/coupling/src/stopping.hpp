#pragma once

#include <string>
#include <vector>

#include "convergence_advice.hpp"

namespace ndframe
{

/// The paper's criterion: stop when eps_tau falls below the tolerance, or after `Maximum Sweeps`. With a goal for the
/// iteration's part of the error, that part takes the place of eps_tau.
class Stopping
{
public:
  Stopping(double tolerance, int maximumSweeps, ConvergenceAdvice advice)
      : tolerance_(tolerance), maximumSweeps_(maximumSweeps), advice_(advice)
  {}

  /// The same with a goal for SweepRecord::iterationError; 0: none.
  Stopping withGoal(double iterationError) const;

  /// eps_tau = |Lambda_dir - Lambda_neu| / (1/2 |Lambda_dir + Lambda_neu|); 0 when both vanish.
  static double measure(const Vector& dirichlet, const Vector& neumann);

  /// True when the iteration must end after the sweeps in the history; fills in the verdict. agree: the contact forces
  /// on the two sides cannot come closer.
  bool ends(CouplingResult& result, bool agree) const;

  /// How far the iteration is after this sweep.
  Progress progress(const SweepRecord& last) const;

  static ListSpec spec();

private:
  double tolerance_;
  int maximumSweeps_;
  ConvergenceAdvice advice_;
  double iterationError_ = 0.0;
};

} // namespace ndframe

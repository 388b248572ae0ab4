#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/base/ledger.hpp"

namespace ndframe
{

/// Conjugate gradients until the true residual is at most `goal`, or round-off: CG follows a residual of its own that
/// drifts, so it is started again on what is left.
///
///   current                                 the norm of the true residual now
///   advance(reduction, iterations, watch)   one run of CG; the iterations it took
///   residual()                              the norm of the true residual after it
///   roundOff()                              what is left of the residual by rounding
///
/// Tells the ledger how far it is. Returns the iterations. Throws NotConverged.
template <class Advance, class Residual, class RoundOff>
int restartedGradients(double goal, double reference, int maxIterations, double current, const Ledger& ledger,
                       const Advance& advance, const Residual& residual, const RoundOff& roundOff)
{
  double before = current;
  int iterations = 0;
  while (!(current <= goal || (2.0 * current > before && current <= roundOff()))) {
    if (iterations >= maxIterations || !std::isfinite(current))
      throw NotConverged(fmt::format("Krylov: relative residual {:.2e} > {:.2e} after {} iterations; raise \"Maximum "
                                     "Iterations\" or use another preconditioner or a direct solver",
                                     current / reference, goal / reference, iterations));
    const auto watch = [&, share = current / reference](int iteration, double left) {
      ledger.tell(Depth::Iteration,
                  Progress::falling("iteration", iterations + iteration, "residual", left * share, goal / reference));
    };
    iterations += std::max(advance(0.5 * goal / current, maxIterations - iterations, watch), 1);
    before = std::exchange(current, residual());
  }
  return iterations;
}

} // namespace ndframe

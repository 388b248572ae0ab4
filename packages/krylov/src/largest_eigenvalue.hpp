#pragma once

#include "fine_level.hpp"

namespace ndframe
{

/// The largest eigenvalue of D^-1 K, D the diagonal of K on the interior dofs, from below: `steps` steps of Lanczos on
/// D^-1/2 K D^-1/2, one product each, from a start that depends on the numbers of the dofs only.
///
/// As many steps of the power method are far less: in the worst case the relative error is 0.1 (log n / steps)^2 here
/// and 0.9 log n / steps there (Kuczynski and Wozniakowski, 1992).
double largestEigenvalue(const FineOperator& K, const std::vector<double>& inverseDiagonal, int steps);

} // namespace ndframe

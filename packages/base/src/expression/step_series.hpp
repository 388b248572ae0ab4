#pragma once

#include "interval_series.hpp"

namespace ndframe
{

/// Whether a comparison of a range with zero holds, as 1, 0 or [0, 1]; a range that only touches zero holds almost
/// everywhere.
Interval comparison(Operation operation, Interval a);

/// Whether a number of the range is not zero.
Interval truth(Interval a);

/// A step: constant where it is decided.
Series constantOn(Interval range);

} // namespace ndframe

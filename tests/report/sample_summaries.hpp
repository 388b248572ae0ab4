#pragma once

#include "ndframe/run/run_summary.hpp"

namespace ndframe::test
{

/// Two bodies, one interface, two sweeps, every list filled; one value is not a number.
RunSummary contactSummary();

/// One body, nothing else.
RunSummary singleBodySummary();

} // namespace ndframe::test

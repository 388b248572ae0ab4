#pragma once

#include "ndframe/run/run.hpp"
#include "ndframe/run/run_settings.hpp"

namespace ndframe
{

/// Says why the result of a complete summary may not be trusted; empty when it may. A failed check overrules an
/// iteration that calls itself converged: the summary says so then.
std::string verdictOn(RunSummary& summary, const Solved& solved, const RunSettings& settings);

} // namespace ndframe

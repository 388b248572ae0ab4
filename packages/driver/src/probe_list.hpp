#pragma once

#include "ndframe/base/param_spec.hpp"
#include "ndframe/run/probe_options.hpp"

namespace ndframe
{

/// Output/Probes.
ListSpec probesSpec();

/// Reads the list Output's probes.
std::vector<ProbeOptions> probesOf(const Params& output);

} // namespace ndframe

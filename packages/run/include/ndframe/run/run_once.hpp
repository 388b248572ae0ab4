#pragma once

#include "ndframe/run/run_steps.hpp"
#include "ndframe/run/shared_passes.hpp"

namespace ndframe
{

/// Runs a deck on the meshes that it names up to the summary, starting with what it may take over of an earlier run:
/// `previous`, which holds what can still be reused when this throws. sweeps: kept, and gone on from; `shared` belongs
/// to them and is set before they are kept.
Run runOnce(const RunTools& tools, RunObserver& observer, Reusable&& previous, SweepsKept sweeps, SharedPasses& shared);

/// The same without sweeps.
Run runOnce(const RunTools& tools, RunObserver& observer, Reusable&& previous);

} // namespace ndframe

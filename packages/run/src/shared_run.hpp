#pragma once

#include "ndframe/run/run_steps.hpp"
#include "ndframe/scene/shared_scene.hpp"

namespace ndframe
{

/// Whether ranks can have shares of what a deck describes, as far as it says so without its meshes.
bool mayBeShared(const RunSettings& settings, int ranks);

/// The scene on its meshes as drawn, where ranks can have shares of the refined ones: several ranks solve solids
/// whole, by Multigrid, and nothing asks for all of a body (a certificate, probes, a checkpoint,
/// one Exodus file). Without a model where bodies must be whole. Collective.
DrawnScene drawnToShare(const RunTools& tools);

/// The model is this rank's share of the refined scene. Counts "shared bodies". Collective.
void takeShares(Model& model, const DrawnScene& drawn, const RunTools& tools);

} // namespace ndframe

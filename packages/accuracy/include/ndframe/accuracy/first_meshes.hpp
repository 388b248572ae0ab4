#pragma once

#include "ndframe/accuracy/mesh_planner.hpp"
#include "ndframe/run/run_steps.hpp"

namespace ndframe
{

/// Reads the meshes that a deck with the list Accuracy begins with, and checks them: also that they can be refined as
/// the deck says. Returns what refines them.
MeshPlanner readFirstMeshes(Model& model, const RunTools& tools, const AccuracyComponents& components);

} // namespace ndframe

#pragma once

#include "mesh_planner.hpp"
#include "run_steps.hpp"

namespace ndframe
{

/// Reads the meshes that a deck with the list Accuracy begins with, and checks them: also that they can be refined as
/// the deck says. Returns what refines them.
MeshPlanner readFirstMeshes(Model& model, const RunTools& tools);

/// Runs a deck with the list Accuracy up to the summary: solves and certifies on finer and finer meshes until the bound
/// is below the target or a limit is met; `energies`: of earlier runs. The run that is returned is the one on the last
/// mesh or, without the target, on the one with the smallest bound.
Run runToTarget(const Params& deck, const Components& components, const Comm& comm, Ledger& ledger, const Log& log,
                const LevelObserver& onLevel, EnergyRecords energies = {});

} // namespace ndframe

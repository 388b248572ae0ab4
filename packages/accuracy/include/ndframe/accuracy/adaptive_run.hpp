#pragma once

#include "ndframe/accuracy/mesh_planner.hpp"
#include "ndframe/run/run_steps.hpp"

namespace ndframe
{

/// Runs a deck with the list Accuracy up to the summary: solves and certifies on finer and finer meshes until the bound
/// is below the target or a limit is met; `energies`: of earlier runs. The run that is returned is the one on the last
/// mesh or, without the target, on the one with the smallest bound. known: meshes that have been read (updateMeshes).
Run runToTarget(RunTools tools, const AccuracyComponents& components, RunObserver& observer,
                const LevelObserver& onLevel, EnergyRecords energies = {}, Model known = {});

} // namespace ndframe

#pragma once

#include "ndframe/accuracy/mesh_planner.hpp"
#include "ndframe/run/run_steps.hpp"

namespace ndframe
{

/// What a run is told of an earlier one that was ended, and leaves in case that it is ended itself.
struct Restart
{
  /// After every level that another one follows, and on the way through sweeps or status passes; empty: never.
  std::function<void(const Checkpoint&)> write;
  int sweeps = 0; ///< after so many of them each, or after every pass; 0: only after levels
  /// Called where a limit ends the run, to be written behind its results: higher limits go on from the last level.
  std::function<void(Checkpoint&&)> keep;
  std::optional<Checkpoint> from; ///< levels that are there already; none: the run begins with the first
  std::string file;               ///< where it comes from, for messages
};

/// Throws InputError where the checkpoint that a run is to go on from belongs to another deck.
void refuseOtherDeck(const Restart& restart, const RunSettings& settings);

/// The sweeps of a run without levels. Throws as refuseOtherDeck(). Settings, `restart` and `shared`, which is kept
/// with passes (sharedPasses), must live as long as they.
SweepsKept sweepsOf(const Restart& restart, const RunSettings& settings, const SharedPasses& shared);

/// Runs a deck with the list Accuracy up to the summary: solves and certifies on finer and finer meshes until the bound
/// is below the target or a limit is met; `energies`: of earlier runs. The run that is returned is the one on the last
/// mesh or, without the target, on the one with the smallest bound. known: meshes that have been read (updateMeshes).
///
/// restart.from: levels that are not solved again. Their meshes are made again by the same refinements from the same
/// first meshes, interfaces from the meshes, so the run ends with the same bits as one that was not ended. Throws
/// InputError where the deck is another one or the meshes are not the same.
Run runToTarget(RunTools tools, const AccuracyComponents& components, RunObserver& observer,
                const LevelObserver& onLevel, EnergyRecords energies = {}, Model known = {},
                const Restart& restart = {});

} // namespace ndframe

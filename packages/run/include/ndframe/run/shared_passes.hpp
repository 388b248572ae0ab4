#pragma once

#include "ndframe/coupling/coupling.hpp"
#include "ndframe/scene/model.hpp"

namespace ndframe
{

/// What belongs to status passes of solids that are solved whole, so that other ranks can go on from their fields
/// (StatusMemory), whether they have shares of the bodies or all of them.
struct SharedPasses
{
  /// Per field: coordinates of the nodes that it is at, three each. Where ranks have shares those of some of the nodes;
  /// else those of all, on rank 0.
  std::vector<Vector> places;
  std::string interfaces; ///< hash of the coordinates of their nodes, whose order that of the statuses is
  bool isInParts = false; ///< each rank has a part of the fields
};

/// Whether sweeps are status passes of solids that are solved whole; nothing else needs SharedPasses.
bool haveFields(const SweepsDone& done);

/// Whether passes can go on with this model: interfaces have the same nodes in the same order, as those of one scene
/// have whatever the ranks have of it.
bool arePassesOf(const SweepsDone& done, const SharedPasses& shared, const Model& model);

/// The passes of a run with this model: `shared` is set before passes are kept, and passes that are gone on from get
/// the fields at this rank's nodes, found by their coordinates where these are not theirs; they are the same to the bit
/// whatever the shares. Throws InputError where they are not its passes. Model and `shared` must live as long as they.
/// Collective.
SweepsKept sharedPasses(SweepsKept sweeps, const Model& model, SharedPasses& shared, const Comm& comm);

} // namespace ndframe

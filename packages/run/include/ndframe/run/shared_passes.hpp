#pragma once

#include "ndframe/coupling/coupling.hpp"
#include "ndframe/scene/model.hpp"

namespace ndframe
{

/// What belongs to status passes with fields (StatusMemory), so that any number of ranks can go on from them, with
/// shares of the bodies or with all of them.
struct SharedPasses
{
  bool areParts = false;      ///< each rank has the fields at its own nodes; else each has all of them
  std::vector<Vector> places; ///< per field: coordinates of the nodes that it is at, three each
  std::string interfaces;     ///< hash of their nodes, whose order that of the statuses is
};

/// Whether such passes can go on with this model: where they or it are of shares, the interfaces have the same nodes in
/// the same order. It depends on the number of ranks: meshes may be refined before they are shared out, and of whole
/// bodies the order is another one.
bool arePassesOf(const SweepsDone& done, const SharedPasses& shared, const Model& model);

/// The passes of a run with this model: `shared` is set before passes are kept, and where passes that are gone on from
/// or the model are of shares, they get the fields at this rank's nodes, found by their coordinates; these are the same
/// to the bit whatever the shares. Throws InputError where they are not its passes. Limit: bodies
/// that touch themselves have two nodes at one place. Model and `shared` must live as long as they. Collective.
SweepsKept sharedPasses(SweepsKept sweeps, const Model& model, SharedPasses& shared, const Comm& comm);

} // namespace ndframe

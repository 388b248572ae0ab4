#pragma once

#include "ndframe/coupling/coupling.hpp"
#include "ndframe/scene/model.hpp"

namespace ndframe
{

/// What belongs to status passes of bodies that ranks have shares of: each rank has the fields (StatusMemory) at some
/// of the nodes, and other ranks can go on from them.
struct SharedPasses
{
  std::vector<Vector> places; ///< per field: coordinates of the nodes that it is at, three each; none: fields are whole
  std::string interfaces;     ///< hash of their nodes, whose order that of the statuses is
};

/// Whether passes can go on with this model: both are of whole bodies, or of shares whose interfaces have the same
/// nodes in the same order. Meshes that are refined before they are shared out depend on the number of ranks, and the
/// nodes of whole bodies have another order.
bool arePassesOf(const SweepsDone& done, const SharedPasses& shared, const Model& model);

/// The passes of a run with this model: where ranks have shares, `shared` is set before passes are kept, and passes
/// that are gone on from get the fields at this rank's nodes, found by their coordinates; these are the same to the bit
/// whatever the shares. Throws InputError where they are not its passes. Model and `shared` must live as long as they.
/// Collective.
SweepsKept sharedPasses(SweepsKept sweeps, const Model& model, SharedPasses& shared, const Comm& comm);

} // namespace ndframe

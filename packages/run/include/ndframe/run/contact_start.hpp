#pragma once

#include "ndframe/interface/contact_transfer.hpp"
#include "ndframe/run/run.hpp"

namespace ndframe
{

/// The traction that the next sweep would begin with, (27); none at open nodes, where what is left of earlier sweeps
/// decays slowly and costs the bound more than the iteration's part shows: traction times opening. Empty without
/// interfaces.
InterfaceValues nextTraction(const Run& run);

/// A traction at the interface nodes with the run's statuses, for other meshes; empty without interfaces.
CarriedContact contactOf(const Run& run, InterfaceValues traction);

/// Begins with tractions and statuses on the run's own meshes; an empty start without interfaces.
CouplingStart startFrom(const Run& run, const CarriedContact& contact);

/// The same with the contact of another run; an empty start where its interfaces have other nodes.
CouplingStart startLike(const Run& run, const CarriedContact& contact);

} // namespace ndframe

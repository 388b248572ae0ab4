#pragma once

#include "ndframe/condensation/contact_node.hpp"
#include "ndframe/interface/interface_mesh.hpp"
#include "ndframe/run/run_summary.hpp"

namespace ndframe
{

/// Where contact ends inside a plane interface: between neighbouring nodes of which one is closed and one is open. From
/// them the nearest node is sought that is closed and pressed by more than round-off, and the nearest that is open with
/// more than a rounded gap. Such a bracket says where contact ends in the computed state; that it ends there in the
/// solution is not guaranteed. nodes: those of the interface. In order of the closed points; empty in space.
std::vector<EndBracket> endBrackets(const InterfaceMesh& interface, const ContactNode* nodes);

/// The vertices next to which the status changes along a plane interface. closed: per interface node.
std::vector<int> endVertices(const InterfaceMesh& interface, const char* closed);

} // namespace ndframe

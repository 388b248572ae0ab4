#pragma once

#include "ndframe/condensation/contact_node.hpp"
#include "ndframe/interface/interface_mesh.hpp"

namespace ndframe
{

/// The neighbours of every node along a plane interface.
std::vector<std::vector<int>> neighboursAlong(const InterfaceMesh& interface);

/// The connected pieces of a plane interface, each as its nodes in order. A piece with ends goes towards larger
/// coordinates (those along which its ends lie farther apart), a ring begins at its smallest x. Pieces are sorted by
/// the coordinates of their first nodes.
std::vector<std::vector<int>> chainsOf(const InterfaceMesh& interface);

/// The rows of NAME.contact.csv: in the plane sorted along every side, with the arc length from the beginning of its
/// connected piece; in space as they are. nodes: all interfaces' nodes, one interface after the other.
std::vector<ContactNode> sortedAlong(const std::vector<InterfaceMesh>& interfaces,
                                     const std::vector<ContactNode>& nodes);

} // namespace ndframe

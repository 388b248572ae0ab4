#pragma once

#include <vector>

#include "ndframe/interface/body_trace.hpp"

namespace ndframe
{

/// A contact state on other interface meshes of the same interfaces, refined or made anew. Nodes are numbered one
/// interface after another, as in ContactMatrix; both lists have the same interfaces in the same order.
///
/// A node of `to` takes what lies at the nearest point of `from`: on straight sides that is the node's own place, on
/// curved geometry made anew the foot on the old facets. Cost: m log n for m nodes on n facets.

/// A traction's nodal values: the old polynomial (order 1 or 2) at the new nodes. Exact where each new facet lies in
/// one old facet and the order does not fall: then resultants and Bernstein coefficients of one sign stay.
InterfaceValues transferTraction(const std::vector<InterfaceMesh>& from, const InterfaceValues& traction,
                                 const std::vector<InterfaceMesh>& to);

/// Statuses per interface node (1: closed): those of the nearest node of the facet on which the new node lies; closed
/// where an open and a closed one are equally near, for the status method opens many nodes in one pass.
std::vector<char> transferClosed(const std::vector<InterfaceMesh>& from, const std::vector<char>& closed,
                                 const std::vector<InterfaceMesh>& to);

/// Statuses per interface node from those per unknown; nodes without unknown count as closed.
std::vector<char> statusesOfNodes(const InterfaceSystem& system, const std::vector<char>& ofUnknowns);
/// Statuses per unknown from those per interface node.
std::vector<char> statusesOfUnknowns(const InterfaceSystem& system, const std::vector<char>& ofNodes);

} // namespace ndframe

#pragma once

#include "sweep.hpp"

namespace ndframe
{

/// Lambda_0: the traction before the first sweep.
using InitialTraction = InterfaceValues (*)(const InterfaceSystem& system, const RoleSystem& dirichlet,
                                            const RoleSystem& neumann);

/// "Zero" (the paper), "Balanced". Both balance the loads of floating Neumann bodies.
const Names<InitialTraction>& initialTractions();

/// The traction nearest to a given one that carries the loads of all floating bodies and puts no force on the nodes
/// where supports prescribe the normal displacement.
InterfaceValues carriedTraction(const InterfaceSystem& system, const RoleSystem& dirichlet, const RoleSystem& neumann,
                                const InterfaceValues& given);

} // namespace ndframe

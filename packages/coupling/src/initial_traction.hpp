#pragma once

#include "sweep.hpp"

namespace ndframe
{

/// Lambda_0: the traction before the first sweep, per interface node.
using InitialTraction = Vector (*)(const InterfaceSystem& system, const RoleSystem& dirichlet,
                                   const RoleSystem& neumann);

/// "Zero" (the paper), "Balanced". Both balance the loads of floating Neumann bodies.
const Names<InitialTraction>& initialTractions();

} // namespace ndframe

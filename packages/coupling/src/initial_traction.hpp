#pragma once

#include "sweep.hpp"

namespace ndframe
{

/// Lambda_0: the traction before the first sweep, per interface node.
using InitialTraction = Vector (*)(const InterfaceSystem& system, const RoleSystem& dirichlet);

/// "Zero" (the paper), "Balanced".
const Names<InitialTraction>& initialTractions();

} // namespace ndframe

#pragma once

#include <memory>

#include "ndframe/interface/body_trace.hpp"
#include "ndframe/scene/model.hpp"

namespace ndframe
{

/// The conditions of a system whose unknowns, basis and contact matrix are known, where interfaces are `isMortar`: the
/// means over their MortarFunctions, in Bernstein's form where the system has a basis. Null where those are nothing but
/// the unknowns.
///
/// Cost: a solve with the mass matrix of a side per function.
std::shared_ptr<const MortarSpace> mortarSpace(const Model& model, const InterfaceSystem& system);

} // namespace ndframe

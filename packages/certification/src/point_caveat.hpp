#pragma once

#include <string>

#include "certificate_steps.hpp"

namespace ndframe
{

/// Why a bound is not guaranteed where a support Point carries a force: no stress of finite energy is in equilibrium
/// with it, so the scene has no exact solution. Empty when all of them carry nothing but round-off.
std::string pointCaveat(const CertifiedScene& scene, const Comm& comm);

} // namespace ndframe

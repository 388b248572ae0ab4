#pragma once

#include "ndframe/coupling/relaxation_controller.hpp"

namespace ndframe
{

void registerConstant(Registry<RelaxationController>& registry);
void registerAitken(Registry<RelaxationController>& registry);

} // namespace ndframe

#pragma once

#include "ndframe/coupling/relaxation_controller.hpp"

namespace ndframe
{

void registerAutomatic(Registry<RelaxationController>& registry);
void registerConstant(Registry<RelaxationController>& registry);
void registerAitken(Registry<RelaxationController>& registry);

} // namespace ndframe

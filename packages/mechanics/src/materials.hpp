#pragma once

#include "ndframe/mechanics/material_law.hpp"

namespace ndframe
{

/// The key that every law of a two- or three-dimensional body has.
ParamSpec hypothesisSpec();

void registerIsotropic(Registry<MaterialLaw>& registry);
void registerOrthotropic(Registry<MaterialLaw>& registry);

} // namespace ndframe

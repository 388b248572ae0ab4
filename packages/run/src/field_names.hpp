#pragma once

#include "ndframe/scene/model.hpp"

namespace ndframe
{

/// Refuses names of bodies, sides and interfaces that are too long for NAME.e.
void checkFieldNames(const Model& model, const SceneSettings& scene, Diagnostics& diagnostics);

} // namespace ndframe

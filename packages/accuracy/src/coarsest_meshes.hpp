#pragma once

#include "ndframe/scene/model.hpp"

namespace ndframe
{

/// Coarse meshes to begin with: boxes with as few cells as their splits allow and with which the sides of interfaces
/// still match, meshes from files as they are. Empty where that needs the deck's own meshes.
MeshOfBody coarsestMeshes(const SceneSettings& scene, const SceneComponents& components, const Comm& comm,
                          Ledger& ledger);

} // namespace ndframe

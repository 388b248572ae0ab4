#pragma once

#include "ndframe/scene/model.hpp"

namespace ndframe
{

/// Makes the meshes of an earlier (or empty) model the deck's, before the rest of the scene is built: a model that has
/// them already stays as it is, any other one has meshes and nothing else then, which updateModel() takes over.
/// Rank 0 reads for all. Throws InputError like MeshSource::read.
void updateMeshes(Model& model, const SceneSettings& scene, const SceneComponents& components, const Comm& comm,
                  Ledger& ledger);

} // namespace ndframe

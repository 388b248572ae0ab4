#pragma once

#include <vector>

#include "ndframe/mesh/mesh.hpp"
#include "ndframe/scene/scene_settings.hpp"

namespace ndframe
{

/// Which of so many pieces each vertex of the drawn meshes of a scene belongs to: those of all bodies are shared out
/// together (partitionJoined), so that piece r of every body belongs to one part of the scene, and vertices that lie on
/// each other where sides may touch are in one piece. A body need not have a vertex in every piece. meshes: per body;
/// null for rigid ones, which have no vertices here, either. Per body and vertex.
std::vector<std::vector<int>> piecesOfVertices(const std::vector<const Mesh*>& meshes, const SceneSettings& scene,
                                               int pieces);

} // namespace ndframe

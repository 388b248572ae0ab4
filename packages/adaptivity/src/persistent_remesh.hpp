#pragma once

#include <functional>

#include "ndframe/meshing/remesh.hpp"

namespace ndframe
{

/// Makes meshes with these lengths by this algorithm, or throws.
using MeshMaker = std::function<std::vector<Mesh>(const std::vector<WantedMesh>& wanted, GmshAlgorithm algorithm)>;

/// Asks again where gmsh gives up: by other algorithms, with lengths that are a little smaller. Throws the
/// RemeshFailure of the first attempt when none has a mesh; other exceptions pass through at once.
std::vector<Mesh> remeshPersistently(const std::vector<WantedMesh>& wanted, const MeshMaker& make);

} // namespace ndframe

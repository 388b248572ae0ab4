#pragma once

#include "ndframe/algebra/comm.hpp"
#include "ndframe/meshing/mesh_source.hpp"
#include "ndframe/scene/model.hpp"

namespace ndframe
{

/// The mesh as rank 0 reads it, with what it was before its edges were halved, on every rank: a file that changes
/// meanwhile, or that looks different on another machine, cannot give the ranks different meshes. InputError on every
/// rank when rank 0 has one. Limit: 2 GB. drawn: the mesh as drawn where rank 0 has read it before (dim 0: it has not).
GivenMesh readShared(const MeshSource& source, const Comm& comm, ScriptMeshes& scripts, Mesh drawn = {});

} // namespace ndframe

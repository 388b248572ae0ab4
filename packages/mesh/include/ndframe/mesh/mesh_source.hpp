#pragma once

#include <memory>

#include "ndframe/base/registry.hpp"
#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// Where a body's mesh comes from.
class MeshSource
{
public:
  virtual ~MeshSource() = default;
  /// Generates or reads the mesh. Throws InputError (with the deck's place) when a file is missing, corrupt, not a
  /// triangle/tetrahedron mesh, or changes while it is read. The mesh has passed checkMesh and carries no unused
  /// points.
  virtual Mesh read() const = 0;
};

/// "Box", "Gmsh", "Exodus".
void registerMeshSources(Registry<MeshSource>& registry);

} // namespace ndframe

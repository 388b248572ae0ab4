#include "ndframe/scene/shared_mesh.hpp"

#include "ndframe/algebra/from_rank_zero.hpp"
#include "ndframe/mesh/mesh_bytes.hpp"

namespace ndframe
{

Mesh readShared(const MeshSource& source, const Comm& comm, ScriptMeshes& scripts)
{
  if (comm.size() == 1)
    return source.readWith(scripts);
  return meshFromBytes(fromRankZero(comm, [&] { return toBytes(source.readWith(scripts)); }));
}

} // namespace ndframe

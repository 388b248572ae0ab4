#include "ndframe/scene/shared_mesh.hpp"

#include <utility>

#include "ndframe/algebra/from_rank_zero.hpp"
#include "ndframe/mesh/mesh_bytes.hpp"

namespace ndframe
{

Mesh readShared(const MeshSource& source, const Comm& comm, ScriptMeshes& scripts, Mesh drawn)
{
  const auto read = [&] { return drawn.dim > 0 ? source.refined(std::move(drawn)) : source.readWith(scripts); };
  if (comm.size() == 1)
    return read();
  return meshFromBytes(fromRankZero(comm, [&] { return toBytes(read()); }));
}

} // namespace ndframe

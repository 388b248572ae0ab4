#include "ndframe/scene/shared_mesh.hpp"

#include <utility>

#include "ndframe/algebra/from_rank_zero.hpp"
#include "ndframe/mesh/mesh_bytes.hpp"

namespace ndframe
{

namespace
{

template <class Make>
Mesh madeByRankZero(const Comm& comm, const Make& make)
{
  if (comm.size() == 1)
    return make();
  return meshFromBytes(fromRankZero(comm, [&] { return toBytes(make()); }));
}

} // namespace

GivenMesh readShared(const MeshSource& source, const Comm& comm, ScriptMeshes& scripts, Mesh drawn)
{
  const auto read = [&] { return drawn.dim > 0 ? std::move(drawn) : source.drawn().readWith(scripts); };
  Mesh mesh = madeByRankZero(comm, read);
  if (&source.drawn() == &source)
    return mesh;
  Mesh refined = madeByRankZero(comm, [&] { return source.refined(mesh); });
  return {std::move(refined), {}, std::make_shared<const Mesh>(std::move(mesh))};
}

} // namespace ndframe

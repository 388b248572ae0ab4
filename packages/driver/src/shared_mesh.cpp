#include "shared_mesh.hpp"

#include <optional>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/mesh/mesh_bytes.hpp"

namespace ndframe
{

Mesh readShared(const MeshSource& source, const Comm& comm)
{
  if (comm.size() == 1)
    return source.read();
  std::string bytes; // stays empty when the mesh cannot be read
  std::optional<InputError> failure;
  if (comm.rank() == 0) {
    try {
      bytes = toBytes(source.read());
    } catch (const InputError& error) {
      failure = error;
    }
  }
  comm.broadcast(bytes);
  if (bytes.empty())
    throw failure ? *failure : InputError("rank 0 could not read a mesh"); // only rank 0 speaks
  return meshFromBytes(bytes);
}

} // namespace ndframe

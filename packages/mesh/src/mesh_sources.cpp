#include "mesh_sources.hpp"

namespace ndframe
{

void registerMeshSources(Registry<MeshSource>& registry)
{
  registerBox(registry);
  registerGmsh(registry);
  registerExodus(registry);
}

} // namespace ndframe

#include "mesh_sources.hpp"

namespace ndframe
{

void registerMeshSources(Registry<MeshSource>& registry)
{
  registerBox(registry);
  registerGmsh(registry);
  registerExodus(registry);
  registerMeshio(registry);
}

void refuseRemesh(const Params& list, const char* key)
{
  throw InputError(list.mistake(key, "Accuracy/Refinement/Type = Remesh lets gmsh remesh scripts (.geo), and this mesh "
                                     "comes from none; give a script, or refine by Bisection."));
}

} // namespace ndframe

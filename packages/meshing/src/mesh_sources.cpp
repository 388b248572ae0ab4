#include "mesh_sources.hpp"

namespace ndframe
{

NumberedMesh MeshSource::readPieces(int, int) const
{
  throw InternalError("a mesh that is in no pieces is asked for some");
}

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

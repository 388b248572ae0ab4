#pragma once

#include "ndframe/meshing/refined_source.hpp"

namespace ndframe
{

void registerBox(Registry<MeshSource>& registry);
void registerGmsh(Registry<MeshSource>& registry);
void registerExodus(Registry<MeshSource>& registry);
void registerMeshio(Registry<MeshSource>& registry);

/// What MeshSource::script() does where there is none; key: of the list `Mesh`, which says what there is.
[[noreturn]] void refuseRemesh(const Params& list, const char* key);

} // namespace ndframe

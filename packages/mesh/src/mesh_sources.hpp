#pragma once

#include "ndframe/mesh/mesh_source.hpp"

namespace ndframe
{

void registerBox(Registry<MeshSource>& registry);
void registerGmsh(Registry<MeshSource>& registry);
void registerExodus(Registry<MeshSource>& registry);

} // namespace ndframe

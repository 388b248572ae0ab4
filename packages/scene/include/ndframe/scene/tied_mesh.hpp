#pragma once

#include "ndframe/meshing/mesh_source.hpp"

namespace ndframe
{

/// "Tied": the meshes of several parts, glued where sides face each other. The registry's sources before it are what
/// parts are made of.
///
/// Sides need not match: they are cut at each other's vertices (insertion), and vertices that face each other become
/// one, where the first side's is. The cells of a part are the group of its name; groups and sides of a part are called
/// "PART: NAME". Limits: two dimensions; sides that are apart by more than the chords of a curve are refused.
void registerTied(Registry<MeshSource>& registry);

} // namespace ndframe

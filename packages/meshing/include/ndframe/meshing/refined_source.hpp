#pragma once

#include <string>
#include <vector>

#include "ndframe/base/registry.hpp"
#include "ndframe/meshing/mesh_source.hpp"

namespace ndframe
{

/// Registers a source of meshes with the parameter `Refine` = k that all of them have: what it reads has every edge
/// halved k times (refineUniformly), and passes checkMesh again. Refused with the deck's place: more cells than can be
/// numbered, more than there is memory for, cells too small for their distance from the origin.
void addMeshSource(Registry<MeshSource>& registry, std::string name, std::string doc, std::vector<ParamSpec> params,
                   Registry<MeshSource>::Builder builder, std::vector<ListSpec> lists = {});

/// `Refine` of a list `Mesh`: how often its edges are halved.
int halvingsOf(const Params& mesh);

} // namespace ndframe

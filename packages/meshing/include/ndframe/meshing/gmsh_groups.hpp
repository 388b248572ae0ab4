#pragma once

#include <string>
#include <vector>

#include "ndframe/base/params.hpp"
#include "ndframe/meshing/script_meshes.hpp"

namespace ndframe
{

/// Names of the physical groups of cells in the file of a list `Mesh` with `Type` = `Gmsh`, in the order of their tags:
/// what `Regions` may choose. Empty for a file without such groups. Throws InputError like MeshSource::read.
std::vector<std::string> gmshCellGroups(const Params& mesh, ScriptMeshes& scripts);

} // namespace ndframe

#pragma once

#include <string>
#include <vector>

#include "ndframe/mesh/mesh.hpp"
#include "ndframe/reading/msh_file.hpp"

namespace ndframe
{

/// What a physical group is called: its name, or physical_TAG.
std::string gmshGroupName(const std::string& name, int tag);

/// Names of the physical groups of cells that have elements, by their tags.
std::vector<std::string> cellGroupsOf(const MshFile& file);

/// Turns the contents of a .msh file into a mesh. regions: names of the physical groups of cells to keep; empty for
/// all. Throws FileError.
Mesh meshFromMsh(MshFile file, std::vector<std::string> regions);

} // namespace ndframe

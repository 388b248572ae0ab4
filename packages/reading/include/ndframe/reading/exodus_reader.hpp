#pragma once

#include <string>
#include <vector>

#include "ndframe/mesh/numbered_mesh.hpp"

namespace ndframe
{

/// The mesh in an Exodus file, or in several that are its pieces. wanted: names or numbers of the blocks that make it;
/// empty: all of the highest dimension. Throws FileError.
Mesh meshOfExodus(const std::vector<std::string>& paths, const std::vector<std::string>& wanted);

/// What some of its pieces have of a mesh, with the files' numbers of nodes and elements, and all their side sets,
/// empty or not. Throws FileError, also where elements have to be cut.
NumberedMesh partOfExodus(const std::vector<std::string>& paths, const std::vector<std::string>& wanted);

} // namespace ndframe

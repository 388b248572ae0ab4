#pragma once

#include <filesystem>
#include <string>

#include "ndframe/reading/child_process.hpp"

namespace ndframe
{

/// Meshes a gmsh script (.geo) and returns the text of the mesh as a binary .msh file of format 4.1.
///
/// The gmsh library is loaded with dlopen in a child process, so that programs that need no gmsh neither wait for it
/// nor need it. Elements of all entities are kept, with their physical groups. sizeFactor multiplies the sizes of the
/// script. Throws FileError: with gmsh's own messages when the script is wrong, when gmsh needs more than the limits,
/// when the library is missing.
std::string meshGeoFile(const std::string& path, double sizeFactor, ChildLimits limits);

/// A new folder for what gmsh writes.
std::filesystem::path makeScratchFolder();

/// Why gmsh has no mesh, and what to do.
std::string gmshAdvice(const ChildFailure& failure, ChildLimits limits);

} // namespace ndframe

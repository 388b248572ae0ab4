#pragma once

#include <string>
#include <utility>
#include <vector>

namespace ndframe
{

/// What this program was built from.
struct BuildInfo
{
  /// Git commit of the source.
  std::string commit, type, /**< CMake build type */ compiler; ///< "unknown" commit: built outside a clone
  std::vector<std::pair<std::string, std::string>> libraries;  ///< name, version of its headers
};

/// Of this program; the same in all its threads.
const BuildInfo& buildInfo();

/// For main() of a program that knows the commit that it was built from; before anything asks for buildInfo().
void setBuildCommit(const std::string& commit);

} // namespace ndframe

#include "gmsh_library.hpp"

#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>

#include "gmsh_session.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/base/scratch.hpp"
#include "ndframe/reading/file_error.hpp"
#include "ndframe/reading/steady_file.hpp"

namespace ndframe
{

namespace
{

void meshScript(const std::string& script, double sizeFactor, const std::string& mesh)
{
  GmshSession gmsh;
  gmsh.open(script);
  // After opening: a script may set this option too.
  gmsh.setNumber("Mesh.MeshSizeFactor", sizeFactor * gmsh.number("Mesh.MeshSizeFactor"));
  gmsh.generate(gmsh.dimension());
  gmsh.write(mesh);
}

} // namespace

std::filesystem::path makeScratchFolder()
{
  std::error_code noDirectory; // leaves the path empty: the working directory
  std::string pattern = (std::filesystem::temp_directory_path(noDirectory) / "ndframe-XXXXXX").string();
  if (!mkdtemp(pattern.data()))
    throw InputError(fmt::format("no temporary directory can be made as {}; set TMPDIR to a writable place.", pattern));
  return pattern;
}

std::string gmshAdvice(const ChildFailure& failure, ChildLimits limits)
{
  using Reason = ChildFailure::Kind;
  const std::string beforehand = "mesh the script beforehand (gmsh -2 FILE.geo; -3 for a solid)";
  switch (failure.kind()) {
  case Reason::OutOfTime:
    return fmt::format("gmsh did not finish within {} s of processor time. Look for an infinite loop and for too small "
                       "mesh sizes; if it needs more, raise \"Maximum Seconds\" or {}.",
                       limits.cpuSeconds, beforehand);
  case Reason::OutOfMemory:
    return fmt::format("gmsh asks for more memory than is free. Look for too small mesh sizes; if it needs more, {} on "
                       "a larger machine.",
                       beforehand);
  case Reason::StartsProgram:
    return fmt::format("the script starts another program (SystemCall, OnelabRun or the like). Look at what it starts; "
                       "if you trust it, set \"Allow Commands\" = true, or {}.",
                       beforehand);
  case Reason::Unwatched:
    return fmt::format("this system has no way to keep a script from starting programs (seccomp). If you trust it, set "
                       "\"Allow Commands\" = true, or {}.",
                       beforehand);
  case Reason::Exited:
    return "the script ended gmsh before it had a mesh; is there an Exit in it?";
  default:
    return failure.what();
  }
}

std::string meshGeoFile(const std::string& path, double sizeFactor, ChildLimits limits)
{
  const Scratch folder(makeScratchFolder());
  const std::string mesh = (folder.path() / "mesh.msh").string();
  const auto work = [&] {
    meshScript(path, sizeFactor, mesh);
    return std::string();
  };
  try {
    runInChild(work, "gmsh", limits);
  } catch (const ChildFailure& failure) {
    throw FileError(gmshAdvice(failure, limits));
  }
  return readText(mesh);
}

} // namespace ndframe

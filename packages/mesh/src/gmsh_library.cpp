#include "gmsh_library.hpp"

#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <gmshc.h>

#include "file_error.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/base/scratch.hpp"

namespace ndframe
{

namespace
{

/// The functions that are used, bound at run time; nothing links gmsh.
class Library
{
public:
  static const Library& get()
  {
    static const Library library;
    return library;
  }

  decltype(&gmshInitialize) initialize = bind<decltype(&gmshInitialize)>("gmshInitialize");
  decltype(&gmshFinalize) finalize = bind<decltype(&gmshFinalize)>("gmshFinalize");
  decltype(&gmshOptionSetNumber) setNumber = bind<decltype(&gmshOptionSetNumber)>("gmshOptionSetNumber");
  decltype(&gmshOptionGetNumber) getNumber = bind<decltype(&gmshOptionGetNumber)>("gmshOptionGetNumber");
  decltype(&gmshOpen) open = bind<decltype(&gmshOpen)>("gmshOpen");
  decltype(&gmshModelGetDimension) dimension = bind<decltype(&gmshModelGetDimension)>("gmshModelGetDimension");
  decltype(&gmshModelMeshGenerate) generate = bind<decltype(&gmshModelMeshGenerate)>("gmshModelMeshGenerate");
  decltype(&gmshWrite) write = bind<decltype(&gmshWrite)>("gmshWrite");
  decltype(&gmshLoggerStart) startLog = bind<decltype(&gmshLoggerStart)>("gmshLoggerStart");
  decltype(&gmshLoggerStop) stopLog = bind<decltype(&gmshLoggerStop)>("gmshLoggerStop");
  decltype(&gmshLoggerGet) getLog = bind<decltype(&gmshLoggerGet)>("gmshLoggerGet");
  decltype(&gmshFree) free = bind<decltype(&gmshFree)>("gmshFree");

private:
  template <class Function>
  static Function bind(const char* name)
  {
    static void* const handle = dlopen(NDFRAME_GMSH_SONAME, RTLD_LAZY | RTLD_LOCAL);
    if (!handle)
      throw FileError(fmt::format("a .geo file needs the gmsh library, which cannot be loaded ({}); install it or mesh "
                                  "the file beforehand (gmsh -2 FILE.geo).",
                                  dlerror()));
    void* const symbol = dlsym(handle, name);
    NDFRAME_ASSERT(symbol, fmt::format("{} has no function {}", NDFRAME_GMSH_SONAME, name));
    return reinterpret_cast<Function>(symbol);
  }
};

/// gmsh between initialisation and finalisation, silent on the terminal.
class Session
{
public:
  Session()
  {
    int error = 0;
    gmsh_.initialize(0, nullptr, 0, &error);
    NDFRAME_ASSERT(error == 0, "gmsh cannot be initialised");
    setNumber("General.Terminal", 0);
    gmsh_.startLog(&error);
  }
  ~Session()
  {
    int error = 0;
    gmsh_.stopLog(&error); // or the next session would find these messages
    gmsh_.finalize(&error);
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  void setNumber(const char* option, double value)
  {
    int error = 0;
    gmsh_.setNumber(option, value, &error);
    NDFRAME_ASSERT(error == 0, fmt::format("gmsh has no option {}", option));
  }

  double number(const char* option) const
  {
    int error = 0;
    double value = 0.0;
    gmsh_.getNumber(option, &value, &error);
    NDFRAME_ASSERT(error == 0, fmt::format("gmsh has no option {}", option));
    return value;
  }

  void open(const std::string& path)
  {
    int error = 0;
    gmsh_.open(path.c_str(), &error);
    requireSuccess(error, "gmsh cannot read the script");
  }

  void generate()
  {
    int error = 0;
    const int dim = gmsh_.dimension(&error);
    if (dim < 2)
      throw FileError("the script makes no surface and no volume.");
    gmsh_.generate(dim, &error);
    requireSuccess(error, "gmsh cannot mesh the script");
  }

  void write(const std::string& path)
  {
    int error = 0;
    gmsh_.write(path.c_str(), &error);
    requireSuccess(error, "gmsh cannot write its mesh to " + path);
  }

private:
  /// Some of gmsh's errors only appear in its log.
  void requireSuccess(int error, const std::string& what)
  {
    std::string messages;
    char** lines = nullptr;
    std::size_t count = 0;
    int logError = 0;
    gmsh_.getLog(&lines, &count, &logError);
    for (std::size_t i = 0; i < count; ++i) {
      const std::string line = lines[i];
      if (line.compare(0, 7, "Error: ") == 0)
        messages += (messages.empty() ? "" : "; ") + line.substr(7);
      gmsh_.free(lines[i]);
    }
    gmsh_.free(lines);
    if (error != 0 || !messages.empty())
      throw FileError(what + (messages.empty() ? "." : ": " + messages + "."));
  }

  const Library& gmsh_ = Library::get();
};

/// The name of a new directory.
std::filesystem::path makeDirectory()
{
  std::error_code noDirectory; // leaves the path empty: the working directory
  std::string pattern = (std::filesystem::temp_directory_path(noDirectory) / "ndframe-XXXXXX").string();
  if (!mkdtemp(pattern.data()))
    throw InputError(fmt::format("no temporary directory can be made as {}; set TMPDIR to a writable place.", pattern));
  return pattern;
}

void meshScript(const std::string& script, double sizeFactor, const std::string& mesh)
{
  Session gmsh;
  gmsh.open(script);
  // After opening: a script may set these options too.
  gmsh.setNumber("Mesh.MeshSizeFactor", sizeFactor * gmsh.number("Mesh.MeshSizeFactor"));
  gmsh.setNumber("Mesh.SaveAll", 1);
  gmsh.setNumber("Mesh.MshFileVersion", 4.1);
  gmsh.setNumber("Mesh.Binary", 1);
  gmsh.generate();
  gmsh.write(mesh);
}

/// Why gmsh has no mesh, and what to do.
std::string adviceFor(const ChildFailure& failure, ChildLimits limits)
{
  using Kind = ChildFailure::Kind;
  const std::string beforehand = "mesh the script beforehand (gmsh -2 FILE.geo; -3 for a solid)";
  switch (failure.kind()) {
  case Kind::OutOfTime:
    return fmt::format("gmsh did not come to an end within {} s of processor time. Look for a loop without end and for "
                       "too small mesh sizes; if it needs more, raise \"Maximum Seconds\" or {}.",
                       limits.cpuSeconds, beforehand);
  case Kind::OutOfMemory:
    return fmt::format("gmsh asks for more memory than is free. Look for too small mesh sizes; if it needs more, {} on "
                       "a larger machine.",
                       beforehand);
  case Kind::Exited:
    return "the script ended gmsh before it had a mesh; is there an Exit in it?";
  default:
    return failure.what();
  }
}

} // namespace

std::string meshGeoFile(const std::string& path, double sizeFactor, ChildLimits limits)
{
  const Scratch folder(makeDirectory());
  const std::string mesh = (folder.path() / "mesh.msh").string();
  const auto work = [&] {
    meshScript(path, sizeFactor, mesh);
    return std::string();
  };
  try {
    runInChild(work, "gmsh", limits);
  } catch (const ChildFailure& failure) {
    throw FileError(adviceFor(failure, limits));
  }
  std::ifstream stream(mesh, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return std::move(text).str();
}

} // namespace ndframe

#include "gmsh_session.hpp"

#include <dlfcn.h>

#include <fmt/format.h>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

namespace
{

constexpr int hxt = 10; ///< a value of Mesh.Algorithm3D

} // namespace

const GmshFunctions& GmshFunctions::get()
{
  static const GmshFunctions functions;
  return functions;
}

void* GmshFunctions::find(const char* name)
{
  static void* const handle = dlopen(NDFRAME_GMSH_SONAME, RTLD_LAZY | RTLD_LOCAL);
  if (!handle)
    throw FileError(fmt::format("a .geo file needs the gmsh library, which cannot be loaded ({}); on Debian 12: "
                                "apt-get install libgmsh4.8, or mesh the file beforehand (gmsh -2 FILE.geo).",
                                dlerror()));
  void* const symbol = dlsym(handle, name);
  NDFRAME_ASSERT(symbol, fmt::format("{} has no function {}", NDFRAME_GMSH_SONAME, name));
  return symbol;
}

GmshSession::GmshSession()
{
  int error = 0;
  gmsh_.initialize(0, nullptr, 0, &error);
  NDFRAME_ASSERT(error == 0, "gmsh cannot be initialised");
  setNumber("General.Terminal", 0);
  gmsh_.startLog(&error);
}

GmshSession::~GmshSession()
{
  int error = 0;
  gmsh_.stopLog(&error); // or the next session would find these messages
  gmsh_.finalize(&error);
}

void GmshSession::setNumber(const char* option, double value)
{
  int error = 0;
  gmsh_.setNumber(option, value, &error);
  NDFRAME_ASSERT(error == 0, fmt::format("gmsh has no option {}", option));
}

double GmshSession::number(const char* option) const
{
  int error = 0;
  double value = 0.0;
  gmsh_.getNumber(option, &value, &error);
  NDFRAME_ASSERT(error == 0, fmt::format("gmsh has no option {}", option));
  return value;
}

void GmshSession::open(const std::string& path)
{
  int error = 0;
  gmsh_.open(path.c_str(), &error);
  requireSuccess(error, "gmsh cannot read the script");
  keepToSteadyMeshers();
}

/// HXT of gmsh 4.8 crashes, hangs or asks for all memory in one of twenty runs of one script, more often on several
/// threads, and makes another mesh each time on one thread, too.
void GmshSession::keepToSteadyMeshers()
{
  for (const char* threads :
       {"General.NumThreads", "Mesh.MaxNumThreads1D", "Mesh.MaxNumThreads2D", "Mesh.MaxNumThreads3D"})
    setNumber(threads, 1);
  if (number("Mesh.Algorithm3D") == hxt)
    setNumber("Mesh.Algorithm3D", gmshDelaunay);
}

int GmshSession::dimension() const
{
  int error = 0;
  const int dim = gmsh_.dimension(&error);
  if (dim < 2)
    throw FileError("the script makes no surface and no volume.");
  return dim;
}

void GmshSession::generate(int dim)
{
  int error = 0;
  gmsh_.generate(dim, &error);
  try {
    requireSuccess(error, "gmsh cannot mesh the script");
  } catch (const FileError& failure) {
    throw GmshGaveUp(failure.what());
  }
}

void GmshSession::write(const std::string& path)
{
  setNumber("Mesh.SaveAll", 1);
  setNumber("Mesh.MshFileVersion", 4.1);
  setNumber("Mesh.Binary", 1);
  int error = 0;
  gmsh_.write(path.c_str(), &error);
  requireSuccess(error, "gmsh cannot write its mesh to " + path);
}

/// Some of gmsh's errors only appear in its log.
void GmshSession::requireSuccess(int error, const std::string& what) const
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

} // namespace ndframe

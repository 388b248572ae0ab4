#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "gmsh_library.hpp"
#include "mesh_sources.hpp"
#include "meshio_script.hpp"
#include "ndframe/base/python_script.hpp"
#include "ndframe/base/scratch.hpp"
#include "ndframe/reading/child_process.hpp"
#include "ndframe/reading/file_error.hpp"
#include "ndframe/reading/gmsh_converter.hpp"
#include "ndframe/reading/steady_file.hpp"

namespace ndframe
{

namespace
{

constexpr int refused = 3;
constexpr int meshioSeconds = 300; ///< processor time; a hundred thousand cells take some seconds

/// The text of the .msh file that the script makes of a mesh.
std::string convertedByMeshio(const std::string& path)
{
  const Scratch folder(makeScratchFolder());
  const auto in = [&](const char* name) { return (folder.path() / name).string(); };
  std::ofstream(in("script.py")) << meshioScript;
  const std::vector<std::string> arguments{in("script.py"), std::filesystem::absolute(path).string(), in("mesh.msh"),
                                           in("message")};
  const auto work = [&]() -> std::string {
    const int code = runPython(arguments, true);
    if (code == pythonNotStarted)
      throw FileError(
          fmt::format("such files are read by meshio for Python, and {} cannot be started.", pythonProgram));
    if (code == refused)
      throw FileError(readText(in("message")));
    if (code != 0)
      throw FileError("meshio failed on this file, or ran out of memory or time.");
    return readText(in("mesh.msh"));
  };
  return runInChild(work, "meshio", {freeMemory(), meshioSeconds, 20 * meshioSeconds});
}

const std::array<std::string, 3> endings{".inp", ".vtu", ".med"};

/// A mesh of another program, read by meshio.
class Meshio final : public MeshSource
{
public:
  explicit Meshio(const Params& params) : params_(params), path_(params.file("File"))
  {
    std::string ending = std::filesystem::path(path_).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    if (std::find(endings.begin(), endings.end(), ending) == endings.end())
      throw InputError(params_.mistake(
          "File", fmt::format("\"{}\" does not end in {}; .msh and .geo files are read with Type = Gmsh, Exodus files "
                              "with Type = Exodus.",
                              path_, fmt::join(endings, ", "))));
  }

  Mesh read() const override
  {
    try {
      const SteadyFile steady(path_);
      readText(path_); // says what is wrong with a file that cannot be opened
      MshFile msh = parseMsh(convertedByMeshio(path_));
      steady.requireUnchanged();
      return meshFromMsh(std::move(msh), params_.get<std::vector<std::string>>("Regions"));
    } catch (const FileError& error) {
      throw InputError(params_.mistake("File", fmt::format("{}: {}", path_, error.what())));
    }
  }

  MeshScript script() const override { refuseRemesh(params_, "Type"); }

private:
  Params params_;
  std::string path_;
};

} // namespace

void registerMeshio(Registry<MeshSource>& registry)
{
  addMeshSource(registry, "Meshio",
                "A mesh of another program: Abaqus or CalculiX (.inp), VTK (.vtu), MED of Salome and code_aster "
                "(.med). Read by meshio for Python (Debian: python3-meshio, for .med python3-h5py), cells reduced to "
                "their vertices and cut into simplices. Groups of cells: *ELSET, groups of MED, integer cell data of "
                "VTU (\"NAME VALUE\"). Sides: node sets (the boundary facets all of whose vertices are in one), sets "
                "of cells of one dimension less, and *SURFACE of element sets; surfaces that name elements by number "
                "are refused. Nodal data, parts and assemblies of .inp are not read.",
                {ParamSpec::required("File", Kind::String, "The file; relative paths start from the deck's folder."),
                 {"Regions", std::vector<std::string>{}, "Groups of cells that make up the body. Empty: all cells."}},
                [](const Params& params) { return std::make_unique<Meshio>(params); });
}

} // namespace ndframe

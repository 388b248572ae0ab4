#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "gmsh_library.hpp"
#include "mesh_sources.hpp"
#include "ndframe/meshing/gmsh_groups.hpp"
#include "ndframe/reading/file_error.hpp"
#include "ndframe/reading/gmsh_converter.hpp"
#include "ndframe/reading/steady_file.hpp"

namespace ndframe
{

namespace
{

/// gmsh reads one statement of a last line that has no line feed and leaves out the others without a word.
void refuseLostStatements(const std::string& script)
{
  const auto begin = script.find_last_of('\n') + 1; // 0 where there is none
  if (std::count(script.begin() + std::ptrdiff_t(begin), script.end(), ';') > 1)
    throw FileError(
        "the last line has several statements and no line feed, and gmsh would read only the first of them; "
        "end the file with a line feed.");
}

/// A mesh made by gmsh.
class Gmsh final : public MeshSource
{
  /// What `use` makes of the file's contents.
  template <class Use>
  auto fromFile(ScriptMeshes& scripts, const Use& use) const
  {
    try {
      const SteadyFile steady(path_);
      const std::string file = readText(path_);
      if (isScript())
        refuseLostStatements(file);
      MshFile msh = parseMsh(isScript() ? scripts.find(way(), [this] { return meshed(); }) : file);
      steady.requireUnchanged();
      return use(std::move(msh));
    } catch (const FileError& error) {
      throw InputError(params_.mistake("File", fmt::format("{}: {}", path_, error.what())));
    }
  }

public:
  explicit Gmsh(const Params& params) : params_(params), path_(params.file("File"))
  {
    for (const char* key : {"Mesh Size Factor", "Maximum Seconds", "Allow Commands"})
      if (params_.isGiven(key) && !isScript())
        throw InputError(params_.mistake(key, "this key changes how a .geo file is meshed; File names a mesh."));
  }

  Mesh read() const override
  {
    Ledger nobody;
    ScriptMeshes alone(nobody);
    return readWith(alone);
  }

  Mesh readWith(ScriptMeshes& scripts) const override
  {
    return fromFile(scripts, [this](MshFile&& msh) { return meshFromMsh(std::move(msh), regions()); });
  }

  std::vector<std::string> cellGroups(ScriptMeshes& scripts) const
  {
    return fromFile(scripts, [](MshFile&& msh) { return cellGroupsOf(msh); });
  }

  MeshScript script() const override
  {
    if (!isScript())
      refuseRemesh(params_, "File");
    return {params_, path_, regions(), params_.get<int>("Maximum Seconds")};
  }

private:
  std::vector<std::string> regions() const { return params_.get<std::vector<std::string>>("Regions"); }
  bool isScript() const { return std::filesystem::path(path_).extension() == ".geo"; }

  /// The script and all that decides what gmsh makes of it.
  std::string way() const
  {
    return fmt::format("{} {} {}", std::filesystem::absolute(path_).string(), params_.get<double>("Mesh Size Factor"),
                       params_.get<bool>("Allow Commands"));
  }

  std::string meshed() const
  {
    const int seconds = params_.get<int>("Maximum Seconds");
    const ChildLimits limits{freeMemory(), seconds, 20 * std::min(seconds, 100'000),
                             params_.get<bool>("Allow Commands")};
    return meshGeoFile(path_, params_.get<double>("Mesh Size Factor"), limits);
  }

  Params params_;
  std::string path_;
};

} // namespace

void registerGmsh(Registry<MeshSource>& registry)
{
  addMeshSource(
      registry, "Gmsh",
      "A mesh of triangles or tetrahedra by gmsh; quadrilaterals, hexahedra, prisms and pyramids are cut into these. "
      "Physical groups of facets are the sides, by their names (unnamed ones: physical_TAG). Second-order elements are "
      "reduced to their vertices. Bodies of one .geo script share one run of gmsh.",
      {ParamSpec::required("File", Kind::String,
                           "A .msh file (format 2.2 or 4.1, ASCII or binary) or a .geo script to be meshed on the fly "
                           "(on one thread, and never with HXT, which crashes in gmsh 4.8 and makes another mesh each "
                           "time); relative paths start from the deck's folder."),
       {"Regions", std::vector<std::string>{},
        "Physical groups of cells that make up the body, e.g. one of two bodies in the file. Empty: all of them, or "
        "all cells if there are no such groups."},
       {"Mesh Size Factor", 1.0, above(0.0), "Multiplies the mesh sizes of a .geo script."},
       {"Maximum Seconds", 300, atLeast(1),
        "Processor time that gmsh may take for a .geo script. A million triangles take about half a minute."},
       {"Allow Commands", false,
        "Let a .geo script start other programs (SystemCall, OnelabRun and the like); otherwise it is refused when it "
        "tries. Scripts that are remeshed (Refinement Remesh) may do so only if all of them may."}},
      [](const Params& params) { return std::make_unique<Gmsh>(params); });
}

std::vector<std::string> gmshCellGroups(const Params& mesh, ScriptMeshes& scripts)
{
  return Gmsh(mesh).cellGroups(scripts);
}

} // namespace ndframe

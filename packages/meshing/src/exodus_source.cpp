#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "mesh_sources.hpp"
#include "ndframe/mesh/mesh_bytes.hpp"
#include "ndframe/mesh/piece_name.hpp"
#include "ndframe/reading/child_process.hpp"
#include "ndframe/reading/exodus_reader.hpp"
#include "ndframe/reading/file_error.hpp"
#include "ndframe/reading/netcdf_header.hpp"
#include "ndframe/reading/steady_file.hpp"

namespace ndframe
{

namespace
{

/// netCDF's own buffers and HDF5's chunk cache are below the first number; a mesh with its tables takes some 30 times
/// the space of its numbers, which a file may hold in single precision and compressed.
ChildLimits limitsFor(const std::vector<std::string>& paths)
{
  std::int64_t bytes = 0;
  for (const std::string& path : paths)
    bytes += std::int64_t(std::filesystem::file_size(path));
  const int seconds = int(5 + (bytes >> 20));
  return {(std::int64_t(64) << 20) + 200 * bytes, seconds, 20 * seconds};
}

/// The file itself, or the pieces that its name stands for.
std::vector<std::string> filesOf(const std::string& path)
{
  std::error_code none;
  const std::vector<std::string> pieces = piecesMeant(path);
  const auto isThere = [&](const std::string& piece) { return std::filesystem::exists(piece, none); };
  if (std::filesystem::exists(path, none) || std::none_of(pieces.begin(), pieces.end(), isThere))
    return {path};
  const auto missing = std::find_if_not(pieces.begin(), pieces.end(), isThere);
  if (missing != pieces.end())
    throw FileError(fmt::format("the piece {} is missing; all {} must be in one folder.", *missing, pieces.size()));
  return pieces;
}

/// A mesh in an Exodus file. Read in a child process: the Exodus, netCDF and HDF5 libraries trust what a file says.
class Exodus final : public MeshSource
{
public:
  explicit Exodus(const Params& params) : params_(params) {}

  Mesh read() const override
  {
    const auto path = params_.file("File");
    try {
      const std::vector<std::string> files = filesOf(path);
      std::vector<SteadyFile> steady(files.begin(), files.end());
      for (const std::string& file : files)
        checkNetcdfHeader(file);
      const auto blocks = params_.get<std::vector<std::string>>("Blocks");
      const auto work = [&] { return toBytes(meshOfExodus(files, blocks)); };
      const std::string bytes = runInChild(work, "the Exodus library", limitsFor(files));
      for (const SteadyFile& file : steady)
        file.requireUnchanged();
      return meshFromBytes(bytes);
    } catch (const FileError& error) {
      throw InputError(params_.mistake("File", fmt::format("{}: {}", path, error.what())));
    }
  }

  MeshScript script() const override { refuseRemesh(params_, "Type"); }

private:
  Params params_;
};

} // namespace

void registerExodus(Registry<MeshSource>& registry)
{
  addMeshSource(
      registry, "Exodus",
      "A mesh of triangles or tetrahedra in an Exodus II file; quadrilaterals, hexahedra, wedges and pyramids are cut "
      "into these. Side sets are the sides, by their names (unnamed ones: sideset_ID). Second-order elements are "
      "reduced to their vertices.",
      {ParamSpec::required("File", Kind::String,
                           "The Exodus file; relative paths start from the deck's folder. NAME.e.4 stands for the four "
                           "pieces NAME.e.4.0, ..., NAME.e.4.3, which are read as one mesh."),
       {"Blocks", std::vector<std::string>{},
        "Names or numbers of the element blocks that make up the body. Empty: all of the highest dimension."}},
      [](const Params& params) { return std::make_unique<Exodus>(params); });
}

} // namespace ndframe

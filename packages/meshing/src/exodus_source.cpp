#include <algorithm>
#include <climits>
#include <filesystem>
#include <functional>

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
    return meshFromBytes(bytesOf(
        0, INT_MAX, [](const auto& files, const auto& blocks) { return toBytes(meshOfExodus(files, blocks)); }));
  }

  int numPieces() const override
  {
    try {
      const std::string path = params_.file("File");
      const std::vector<std::string> files = filesOf(path);
      return files.front() == path ? 0 : int(files.size());
    } catch (const FileError&) { // one is missing, which is said when they are read
      return 0;
    }
  }

  NumberedMesh readPieces(int first, int last) const override
  {
    return numberedMeshFromBytes(bytesOf(
        first, last, [](const auto& files, const auto& blocks) { return toBytes(partOfExodus(files, blocks)); }));
  }

  MeshScript script() const override { refuseRemesh(params_, "Type"); }

private:
  using Names = std::vector<std::string>;

  /// What `read` returns, in a child process, for these of the files and the blocks.
  std::string bytesOf(int first, int last,
                      const std::function<std::string(const Names& files, const Names& blocks)>& read) const
  {
    const auto path = params_.file("File");
    try {
      Names files = filesOf(path);
      files = Names(files.begin() + first, files.begin() + std::min(last, int(files.size())));
      std::vector<SteadyFile> steady(files.begin(), files.end());
      for (const std::string& file : files)
        checkNetcdfHeader(file);
      const auto blocks = params_.get<Names>("Blocks");
      std::string bytes = runInChild([&] { return read(files, blocks); }, "the Exodus library", limitsFor(files));
      for (const SteadyFile& file : steady)
        file.requireUnchanged();
      return bytes;
    } catch (const FileError& error) {
      throw InputError(params_.mistake("File", fmt::format("{}: {}", path, error.what())));
    }
  }

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
      {ParamSpec::required(
           "File", Kind::String,
           "The Exodus file; relative paths start from the deck's folder. NAME.e.4 stands for the four "
           "pieces NAME.e.4.0, ..., NAME.e.4.3, which are read as one mesh; of solids that several processes "
           "share, each reads its own pieces where their number is a multiple of that of the processes."),
       {"Blocks", std::vector<std::string>{},
        "Names or numbers of the element blocks that make up the body. Empty: all of the highest dimension."}},
      [](const Params& params) { return std::make_unique<Exodus>(params); });
}

} // namespace ndframe

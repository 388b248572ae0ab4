#include "scene_file.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "ndframe/algebra/from_rank_zero.hpp"
#include "ndframe/io/atomic_file.hpp"
#include "ndframe/io/exodus_pieces.hpp"

namespace ndframe
{
namespace
{

void removeAll(const std::vector<std::string>& paths)
{
  for (const std::string& path : paths)
    removeEarlier(path);
}

/// The whole, and pieces that are not among those just written.
void removeOthers(const std::string& path, const std::vector<std::string>& written)
{
  std::vector<std::string> pieces = piecesBeside(path);
  const auto isWritten = [&](const std::string& piece) {
    return std::find(written.begin(), written.end(), piece) != written.end();
  };
  pieces.erase(std::remove_if(pieces.begin(), pieces.end(), isWritten), pieces.end());
  removeAll(pieces);
  std::error_code none;
  if (std::filesystem::is_regular_file(path, none))
    removeEarlier(path);
}

/// Gives all pieces their names, or none.
void keepAll(PendingFile& piece, const std::string& name, const Comm& comm)
{
  try {
    onEveryRank(comm, [&] { piece.keep(); });
  } catch (const InputError&) {
    std::error_code ignored; // the failure is told
    std::filesystem::remove(name, ignored);
    throw;
  }
}

} // namespace

bool isInPieces(const OutputOptions& output, const ExodusScene& scene, const Comm& comm)
{
  std::int64_t nodes = 0, cells = 0;
  for (const ExodusBody& body : scene.bodies) {
    nodes += body.nodes->numNodes();
    cells += body.nodes->numCells();
  }
  return cells >= comm.size() && writesPieces(output.exodusFiles, nodes, comm.size());
}

std::vector<std::string> writeWhole(const std::string& path, const SceneContent& content, Ledger& ledger)
{
  const ExodusScene& scene = content.scene;
  const auto write = [&](const std::string& temporary) {
    writeExodus(temporary, scene.title, scene.bodies, scene.sides, content.steps, content.records);
  };
  ledger.count("bytes written", writeAtomically(path, write));
  removeAll(piecesBeside(path));
  return {path};
}

std::vector<std::string> writePieces(const std::string& path, const SceneContent& content, const Comm& comm,
                                     Ledger& ledger)
{
  const ExodusScene& scene = content.scene;
  const ExodusSharing sharing = shareCells(scene.bodies, comm.size(), scene.ranks);
  std::vector<std::string> names;
  for (int piece = 0; piece < comm.size(); ++piece)
    names.push_back(pieceName(path, comm.size(), piece));
  const std::string& own = names[std::size_t(comm.rank())];
  std::optional<PendingFile> file;
  onEveryRank(comm, [&] {
    file.emplace(own, [&](const std::string& temporary) {
      writeExodusPiece(temporary, scene.title, scene.bodies, scene.sides, content.steps, content.records, sharing,
                       comm.rank());
    });
  });
  keepAll(*file, own, comm);
  ledger.count("bytes written", comm.sum(file->bytes()));
  onEveryRank(comm, [&] {
    if (comm.rank() == 0)
      removeOthers(path, names);
  });
  return names;
}

void removeScene(const std::string& path)
{
  removeAll(piecesBeside(path));
  removeEarlier(path);
}

} // namespace ndframe

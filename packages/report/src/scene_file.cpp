#include "scene_file.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <numeric>
#include <optional>

#include "ndframe/algebra/from_rank_zero.hpp"
#include "ndframe/algebra/shared_values.hpp"
#include "ndframe/assembly/share_boundary.hpp"
#include "ndframe/io/atomic_file.hpp"
#include "ndframe/io/exodus_slices.hpp"

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

/// Facets of a share's own cells.
std::int64_t ownFacets(const std::vector<Facet>& facets, int numOwnCells)
{
  return std::count_if(facets.begin(), facets.end(), [numOwnCells](Facet facet) { return facet.cell < numOwnCells; });
}

/// The blocks of a body: own cells of a process follow those of the processes before it.
void numberElements(ExodusWhole& whole, const ExodusBody& body, const Comm& comm)
{
  std::vector<int> own(std::size_t(whole.numOwnCells.back()));
  std::iota(own.begin(), own.end(), 0);
  std::vector<std::vector<int>> blocks(1, own);
  if (!body.parts.empty())
    blocks.clear();
  for (const ExodusPart& part : body.parts) {
    blocks.emplace_back();
    std::copy_if(part.cells.begin(), part.cells.end(), std::back_inserter(blocks.back()),
                 [&](int cell) { return cell < int(own.size()); });
  }
  std::vector<std::int64_t>& numbers = whole.elements.emplace_back(own.size());
  std::int64_t first = 0;
  for (const std::vector<int>& cells : blocks) {
    const auto [before, all] = beforeAndAll(std::int64_t(cells.size()), comm);
    for (std::size_t i = 0; i < cells.size(); ++i)
      numbers[std::size_t(cells[i])] = first + before + std::int64_t(i);
    first += all;
    whole.firstElements.push_back(before);
    whole.numElements.push_back(all);
  }
}

/// Bodies without a share, rigid ones, are the first piece's.
ExodusWhole wholeOf(const ExodusScene& scene, const Comm& comm)
{
  ExodusWhole whole;
  whole.pieces = comm.size();
  whole.piece = comm.rank();
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const BodyShare* const share = scene.shares[b].get();
    const NodeMap& nodes = *scene.bodies[b].nodes;
    whole.nodes.emplace_back(std::size_t(nodes.numNodes()));
    std::iota(whole.nodes.back().begin(), whole.nodes.back().end(), 0);
    if (share != nullptr)
      whole.nodes.back() = share->numbers();
    whole.numNodes.push_back(share != nullptr ? share->numNodes() : nodes.numNodes());
    whole.numCells.push_back(share != nullptr ? share->numCells() : nodes.numCells());
    whole.numOwnCells.push_back(share != nullptr ? share->numOwnCells() : comm.rank() == 0 ? nodes.numCells() : 0);
    numberElements(whole, scene.bodies[b], comm);
  }
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    for (const Side& side : scene.bodies[b].mesh->sides)
      whole.numFacets.push_back(comm.sum(ownFacets(side.facets, whole.numOwnCells[b])));
  for (const ExodusContactSide& side : scene.sides)
    whole.numFacets.push_back(comm.sum(ownFacets(side.facets, whole.numOwnCells[std::size_t(side.body)])));
  return whole;
}

void findBorders(ExodusWhole& whole, const ExodusScene& scene, const Comm& comm)
{
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    whole.borders.emplace_back();
    if (const BodyShare* const share = scene.shares[b].get())
      whole.borders.back() =
          bordersOfShare({*scene.bodies[b].nodes, share->numbers(), share->owners(), share->numOwnCells()}, comm);
  }
}

/// Own nodes of a process follow those of the processes before it.
ExodusSlice sliceOf(const ExodusScene& scene, const ExodusWhole& whole, const Comm& comm)
{
  ExodusSlice slice;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const BodyShare* const share = scene.shares[b].get();
    std::vector<int> own(share != nullptr || comm.rank() > 0 ? 0 : std::size_t(scene.bodies[b].nodes->numNodes()));
    std::iota(own.begin(), own.end(), 0);
    if (share != nullptr)
      own = share->ownNodes();
    auto next = double(beforeAndAll(std::int64_t(own.size()), comm)[0]);
    Vector numbers(std::size_t(scene.bodies[b].nodes->numNodes()), 0.0);
    for (const int node : own)
      numbers[std::size_t(node)] = next++;
    if (share != nullptr)
      share->fetch(numbers, 1);
    slice.ownNodes.push_back(std::move(own));
    slice.numbers.emplace_back(numbers.begin(), numbers.end());
  }
  const auto addFacets = [&](const std::vector<Facet>& facets, std::size_t body) {
    slice.firstFacets.push_back(beforeAndAll(ownFacets(facets, whole.numOwnCells[body]), comm)[0]);
  };
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    for (const Side& side : scene.bodies[b].mesh->sides)
      addFacets(side.facets, b);
  for (const ExodusContactSide& side : scene.sides)
    addFacets(side.facets, std::size_t(side.body));
  return slice;
}

/// One with fewer cells than processes never is.
bool isInPieces(const OutputOptions& output, const ExodusScene& scene, const Comm& comm)
{
  std::int64_t nodes = 0, cells = 0;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const BodyShare* const share = scene.shares.empty() ? nullptr : scene.shares[b].get();
    nodes += share != nullptr ? share->numNodes() : scene.bodies[b].nodes->numNodes();
    cells += share != nullptr ? share->numCells() : scene.bodies[b].nodes->numCells();
  }
  return cells >= comm.size() && writesPieces(output.exodusFiles, nodes, comm.size());
}

} // namespace

bool isWrittenByAll(const OutputOptions& output, const ExodusScene& scene, const Comm& comm)
{
  return !scene.shares.empty() || isInPieces(output, scene, comm);
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

namespace
{

/// One on each rank; all appear or none.
std::vector<std::string> writePieces(const std::string& path, const SceneContent& content, const Comm& comm,
                                     Ledger& ledger)
{
  const ExodusScene& scene = content.scene;
  const bool areShares = !scene.shares.empty();
  const ExodusSharing sharing = areShares ? ExodusSharing() : shareCells(scene.bodies, comm.size(), scene.ranks);
  ExodusWhole whole = areShares ? wholeOf(scene, comm) : ExodusWhole();
  if (areShares)
    findBorders(whole, scene, comm);
  std::vector<std::string> names;
  for (int piece = 0; piece < comm.size(); ++piece)
    names.push_back(pieceName(path, comm.size(), piece));
  const std::string& own = names[std::size_t(comm.rank())];
  std::optional<PendingFile> file;
  onEveryRank(comm, [&] {
    file.emplace(own, [&](const std::string& temporary) {
      if (areShares)
        writeExodusShare(temporary, scene.title, scene.bodies, scene.sides, content.steps, content.records, whole);
      else
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

/// The first rank begins the file, and all add their parts one after the other.
std::vector<std::string> writeInTurn(const std::string& path, const SceneContent& content, const Comm& comm,
                                     Ledger& ledger)
{
  const ExodusScene& scene = content.scene;
  const ExodusWhole whole = wholeOf(scene, comm);
  const ExodusSlice slice = sliceOf(scene, whole, comm);
  std::optional<PendingFile> file;
  onEveryRank(comm, [&] {
    if (comm.rank() == 0)
      file.emplace(path, [&](const std::string& temporary) {
        beginSlices(temporary, scene.title, scene.bodies, scene.sides, content.steps, content.records, whole);
      });
  });
  std::string temporary = file ? file->temporary() : std::string();
  comm.broadcast(temporary);
  for (int turn = 0; turn < comm.size(); ++turn)
    onEveryRank(comm, [&] {
      if (turn == comm.rank())
        orCannotWrite(path, [&] { writeSlice(temporary, scene.bodies, scene.sides, content.steps, whole, slice); });
    });
  onEveryRank(comm, [&] {
    if (comm.rank() != 0)
      return;
    ledger.count("bytes written", std::int64_t(std::filesystem::file_size(temporary)));
    file->keep();
    removeAll(piecesBeside(path));
  });
  return {path};
}

} // namespace

std::vector<std::string> writeByAll(const std::string& path, const OutputOptions& output, const SceneContent& content,
                                    const Comm& comm, Ledger& ledger)
{
  return isInPieces(output, content.scene, comm) ? writePieces(path, content, comm, ledger)
                                                 : writeInTurn(path, content, comm, ledger);
}

void removeScene(const std::string& path)
{
  removeAll(piecesBeside(path));
  removeEarlier(path);
}

} // namespace ndframe

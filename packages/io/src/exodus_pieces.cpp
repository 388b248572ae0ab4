#include "ndframe/io/exodus_pieces.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>
#include <string_view>

#include "exodus_content.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/mesh/partition.hpp"
#include "nemesis_records.hpp"

namespace ndframe
{
namespace
{

std::optional<int> numberIn(std::string_view text)
{
  int number = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && rest == text.data() + text.size() && number >= 0 ? std::optional(number)
                                                                                  : std::nullopt;
}

/// Whether a name is that of a piece of the file `whole`.
bool isPieceOf(const std::string& whole, const std::string& name)
{
  if (name.compare(0, whole.size() + 1, whole + ".") != 0)
    return false;
  const std::string_view ending = std::string_view(name).substr(whole.size() + 1);
  const auto dot = ending.find('.');
  if (dot == std::string_view::npos)
    return false;
  const auto pieces = numberIn(ending.substr(0, dot)), piece = numberIn(ending.substr(dot + 1));
  return pieces && piece && *piece < *pieces && name == pieceName(whole, *pieces, *piece);
}

/// A piece without cells gets one of the largest piece.
void fillEmptyPieces(ExodusSharing& sharing)
{
  std::vector<int> cells(std::size_t(sharing.pieces), 0);
  for (const auto& owners : sharing.owner)
    for (const int owner : owners)
      ++cells[std::size_t(owner)];
  for (auto empty = cells.begin(); (empty = std::find(empty, cells.end(), 0)) != cells.end();) {
    const auto largest = std::max_element(cells.begin(), cells.end());
    for (auto& owners : sharing.owner) {
      const auto cell = std::find(owners.begin(), owners.end(), int(largest - cells.begin()));
      if (cell == owners.end())
        continue;
      *cell = int(empty - cells.begin());
      break;
    }
    --*largest;
    ++*empty;
  }
}

std::vector<ExodusStep> restricted(const std::vector<ExodusStep>& steps, const PieceScene& scene)
{
  std::vector<ExodusStep> ofPiece;
  for (const ExodusStep& step : steps)
    ofPiece.push_back(scene.restricted(step));
  return ofPiece;
}

} // namespace

ExodusSharing cellsOfPieces(const std::vector<ExodusBody>& bodies, int pieces,
                            const std::vector<std::vector<int>>& pieceOfVertex)
{
  ExodusSharing sharing{pieces, {}};
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Mesh& mesh = *bodies[b].mesh;
    sharing.owner.emplace_back();
    for (int cell = 0; cell < mesh.numCells(); ++cell) {
      const int lowest = *std::min_element(mesh.cell(cell), mesh.cell(cell) + mesh.dim + 1);
      sharing.owner.back().push_back(pieceOfVertex[b][std::size_t(lowest)]);
    }
  }
  return sharing;
}

ExodusSharing shareCells(const std::vector<ExodusBody>& bodies, int pieces,
                         const std::vector<std::vector<int>>& pieceOfVertex)
{
  std::vector<std::vector<int>> own;
  std::size_t cells = 0;
  for (const ExodusBody& body : bodies) {
    const Mesh& mesh = *body.mesh;
    cells += std::size_t(mesh.numCells());
    if (pieceOfVertex.empty())
      own.push_back(partitionNodes(mesh.cells, mesh.dim + 1, mesh.numPoints(), pieces));
  }
  NDFRAME_ASSERT(cells >= std::size_t(pieces), "a piece has a cell");
  ExodusSharing sharing = cellsOfPieces(bodies, pieces, pieceOfVertex.empty() ? own : pieceOfVertex);
  fillEmptyPieces(sharing);
  return sharing;
}

std::vector<std::string> piecesBeside(const std::string& path)
{
  const std::filesystem::path whole(path);
  const auto folder = whole.has_parent_path() ? whole.parent_path() : std::filesystem::path(".");
  std::vector<std::string> found;
  std::error_code none;
  for (std::filesystem::directory_iterator entry(folder, none), end; entry != end; entry.increment(none))
    if (entry->is_regular_file(none) && isPieceOf(whole.filename().string(), entry->path().filename().string()))
      found.push_back((whole.parent_path() / entry->path().filename()).string());
  std::sort(found.begin(), found.end());
  return found;
}

void writeExodusPiece(const std::string& path, const std::string& title, const std::vector<ExodusBody>& bodies,
                      const std::vector<ExodusContactSide>& contactSides, const std::vector<ExodusStep>& steps,
                      const std::vector<std::string>& infoLines, const ExodusSharing& sharing, int piece)
{
  const ExodusLayout whole = makeLayout(bodies, contactSides);
  commonVariables(whole, steps);
  const PieceScene scene(bodies, contactSides, sharing, piece);
  const ExodusLayout layout = makeLayout(scene.bodies(), scene.sides());
  NemesisRecords records(whole, layout, scene, sharing, piece);
  writeContent(path, title, layout, restricted(steps, scene), infoLines, [&](ExodusFile& file) { records.put(file); });
}

void writeExodusShare(const std::string& path, const std::string& title, const std::vector<ExodusBody>& bodies,
                      const std::vector<ExodusContactSide>& contactSides, const std::vector<ExodusStep>& steps,
                      const std::vector<std::string>& infoLines, const ExodusWhole& whole)
{
  ExodusSharing sharing{whole.pieces, {}};
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    sharing.owner.emplace_back(std::size_t(bodies[b].nodes->numCells()), -1);
    std::fill_n(sharing.owner.back().begin(), whole.numOwnCells[b], whole.piece);
  }
  commonVariables(makeLayout(bodies, contactSides), steps);
  const PieceScene scene(bodies, contactSides, sharing, whole.piece);
  const ExodusLayout layout = makeLayout(scene.bodies(), scene.sides());
  NemesisRecords records(layout, scene, whole);
  writeContent(path, title, layout, restricted(steps, scene), infoLines, [&](ExodusFile& file) { records.put(file); });
}

} // namespace ndframe

#include "decompose.hpp"

#include <algorithm>
#include <memory>
#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ndframe/io/atomic_file.hpp"
#include "ndframe/io/exodus_pieces.hpp"
#include "ndframe/report/outputs.hpp"
#include "ndframe/scene/read_meshes.hpp"
#include "ndframe/scene/vertex_pieces.hpp"

namespace ndframe
{
namespace
{

/// The groups of a mesh as element blocks, and the cells of none as a block of their own.
std::vector<ExodusPart> blocksOf(const BodySettings& body, const Mesh& mesh)
{
  std::vector<ExodusPart> blocks;
  if (mesh.groups.kind.empty()) {
    blocks.push_back({body.name, std::vector<int>(std::size_t(mesh.numCells()))});
    std::iota(blocks.front().cells.begin(), blocks.front().cells.end(), 0);
    return blocks;
  }
  for (const auto& names : mesh.groups.names) {
    if (names.size() > 1)
      throw InputError(body.shape.mistake(
          "", fmt::format("cells of \"{}\" belong to several groups ({}), which element blocks of a file cannot; name "
                          "groups that do not overlap.",
                          body.name, fmt::join(names, ", "))));
    blocks.push_back({names.empty() ? body.name : names.front(), {}});
  }
  for (auto& block : blocks)
    while (std::count_if(blocks.begin(), blocks.end(), [&](const auto& other) { return other.name == block.name; }) > 1)
      block.name += " (rest)"; // the cells of no group, where one is called like the body
  for (int cell = 0; cell < mesh.numCells(); ++cell)
    blocks[std::size_t(mesh.groups.kind[std::size_t(cell)])].cells.push_back(cell);
  return blocks;
}

void refuseWhatCannotBe(const SceneSettings& scene, const std::vector<const Mesh*>& meshes, int pieces)
{
  std::int64_t cells = 0;
  for (std::size_t b = 0; b < meshes.size(); ++b) {
    if (meshes[b] == nullptr)
      continue;
    const Params& shape = scene.bodies[b].shape;
    if (shape.get<std::string>("Type") == "Tied")
      throw InputError(shape.mistake(
          "", "several bodies are tied to one here; decompose the deck without Tied interfaces, which can be tied "
              "after that."));
    cells += meshes[b]->numCells();
  }
  if (cells < pieces)
    throw InputError(
        scene.bodiesPlace.mistake("", fmt::format("have {} cells together, too few for {} pieces.", cells, pieces)));
}

/// Writes all pieces of a mesh; they appear when the last one is complete.
void writePieces(const std::string& path, const BodySettings& body, const Mesh& mesh,
                 const std::vector<int>& pieceOfVertex, int pieces)
{
  const NodeMap nodes = makeNodeMap(mesh, 1);
  const std::vector<ExodusBody> bodies{{"", &mesh, &nodes, blocksOf(body, mesh)}};
  const ExodusSharing sharing = cellsOfPieces(bodies, pieces, {pieceOfVertex});
  std::vector<std::unique_ptr<PendingFile>> files;
  for (int piece = 0; piece < pieces; ++piece)
    files.push_back(std::make_unique<PendingFile>(pieceName(path, pieces, piece), [&](const std::string& temporary) {
      writeExodusPiece(temporary, body.name, bodies, {}, {}, {}, sharing, piece);
    }));
  for (const auto& file : files)
    file->keep();
}

/// The pieces of a body's mesh as drawn, and the settings that make the deck read them, whose Refine stays.
std::string writeBody(const BodySettings& body, const Mesh& mesh, const std::vector<int>& pieceOfVertex, int pieces,
                      const std::string& stem)
{
  const std::string path = fmt::format("{}.{}.e", stem, body.name);
  writePieces(path, body, mesh, pieceOfVertex, pieces);
  return fmt::format(" \\\n    --set \"Bodies/{0}/Mesh/Type=Exodus\" --set \"Bodies/{0}/Mesh/File={1}.{2}\"", body.name,
                     path, pieces);
}

} // namespace

std::string decompose(const RunSettings& settings, int pieces, const Components& components,
                      const std::string& deckName, const Comm& comm)
{
  const SceneSettings& scene = settings.scene;
  Model model;
  Ledger ledger;
  updateMeshes(model, scene, components, comm, ledger);
  std::string text;
  writeOnFirstRank(comm, [&] {
    std::vector<const Mesh*> meshes;
    for (std::size_t b = 0; b < model.bodies.size(); ++b) {
      const BodyModel& body = model.bodies[b];
      meshes.push_back(scene.bodies[b].isRigid ? nullptr : body.drawn ? body.drawn.get() : &body.mesh);
    }
    refuseWhatCannotBe(scene, meshes, pieces);
    const std::vector<std::vector<int>> pieceOfVertex = piecesOfVertices(meshes, scene, pieces);
    const std::string stem = outputStem(settings.output, deckName).string();
    for (std::size_t b = 0; b < meshes.size(); ++b)
      if (meshes[b] != nullptr)
        text += writeBody(scene.bodies[b], *meshes[b], pieceOfVertex[b], pieces, stem);
  });
  return fmt::format("  wrote {} piece{} of each mesh; the deck reads them with{}", pieces, pieces == 1 ? "" : "s",
                     text);
}

} // namespace ndframe

#include "ndframe/recovery/scene_pieces.hpp"

#include "ndframe/mesh/partition.hpp"

namespace ndframe
{
namespace
{

using Owners = std::vector<std::vector<int>>;   ///< per body and cell
using Touched = std::vector<std::vector<char>>; ///< per body and vertex

void addCentres(const Mesh& mesh, std::vector<std::array<double, 3>>& centres)
{
  centres.reserve(centres.size() + std::size_t(mesh.numCells()));
  for (int cell = 0; cell < mesh.numCells(); ++cell)
    centres.push_back(cellCentre(mesh, cell));
}

Owners owners(const RecoveryScene& scene, bool together, int ranks)
{
  Owners result(scene.bodies.size());
  std::vector<std::array<double, 3>> centres;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    if (const auto& share = scene.bodies[b]->share)
      result[b] = share->cells().owners;
    if (scene.bodies[b]->isRigid || scene.bodies[b]->share)
      continue;
    if (!together)
      centres.clear();
    addCentres(scene.bodies[b]->mesh, centres);
    if (!together)
      result[b] = partitionByPlace(centres, ranks);
  }
  if (!together)
    return result;
  const std::vector<int> all = partitionByPlace(centres, ranks);
  auto next = all.begin();
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    if (!scene.bodies[b]->isRigid && !scene.bodies[b]->share) {
      result[b].assign(next, next + scene.bodies[b]->mesh.numCells());
      next += scene.bodies[b]->mesh.numCells();
    }
  return result;
}

/// The vertices of a patch's side as the patch orders them.
std::array<int, 3> verticesOf(const RecoveryScene& scene, const PatchSide& side)
{
  const Mesh& mesh = scene.bodies[std::size_t(side.body)]->mesh;
  const SortedCell cell = sortedCell(mesh, side.facet.cell);
  const int facet = sortedFacet(mesh, side.facet);
  std::array<int, 3> vertices{};
  for (int i = 0, n = 0; i < 4; ++i)
    if (i != facet)
      vertices[std::size_t(side.places[std::size_t(n++)])] = cell.vertices[std::size_t(i)];
  return vertices;
}

/// Own vertices, and those that face one in contact.
Touched touched(const RecoveryScene& scene, const Owners& owner, bool together, int rank)
{
  Touched result(scene.bodies.size());
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Mesh& mesh = scene.bodies[b]->mesh;
    result[b].assign(std::size_t(mesh.numPoints()), 0);
    for (std::size_t cell = 0; cell < owner[b].size(); ++cell)
      for (int i = 0; owner[b][cell] == rank && i < 4; ++i)
        result[b][std::size_t(mesh.cell(int(cell))[i])] = 1;
  }
  for (bool changes = together; changes;) {
    changes = false;
    for (const ContactPatch& patch : scene.patches) {
      if (scene.bodies[std::size_t(patch.sides[0].body)]->isRigid ||
          scene.bodies[std::size_t(patch.sides[1].body)]->isRigid)
        continue;
      const auto first = verticesOf(scene, patch.sides[0]), second = verticesOf(scene, patch.sides[1]);
      for (std::size_t i = 0; i < 3; ++i) {
        char &a = result[std::size_t(patch.sides[0].body)][std::size_t(first[i])],
             &b = result[std::size_t(patch.sides[1].body)][std::size_t(second[i])];
        changes = changes || a != b;
        a = b = char(a != 0 || b != 0);
      }
    }
  }
  return result;
}

} // namespace

std::shared_ptr<const ScenePieces> cutScene(const RecoveryScene& scene, bool together, const Comm& comm)
{
  auto pieces = std::make_shared<ScenePieces>();
  const Owners owner = owners(scene, together, comm.size());
  const Touched isTouched = touched(scene, owner, together, comm.rank());
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    pieces->bodies.push_back(
        scene.bodies[b]->isRigid
            ? nullptr
            : std::make_unique<BodyPiece>(cutPiece(*scene.bodies[b], scene.data[b], owner[b], isTouched[b], comm)));
  pieces->patches = scene.patches;
  for (ContactPatch& patch : pieces->patches)
    for (PatchSide& side : patch.sides)
      if (const auto& piece = pieces->bodies[std::size_t(side.body)]; piece && side.facet.cell >= 0)
        side.facet.cell = piece->local(side.facet.cell);
  return pieces;
}

void gatherPieces(const ScenePieces& pieces, std::vector<StressCorrection>& corrections, const Comm& comm)
{
  for (std::size_t b = 0; b < corrections.size(); ++b)
    if (const auto& piece = pieces.bodies[b])
      piece->gather(corrections[b], comm);
}

} // namespace ndframe

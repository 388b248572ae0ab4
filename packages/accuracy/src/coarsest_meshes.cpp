#include "coarsest_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "matching_stations.hpp"
#include "ndframe/meshing/refined_source.hpp"
#include "ndframe/scene/shared_mesh.hpp"

namespace ndframe
{
namespace
{

/// An even grid with no more cells along the largest box is coarse enough.
constexpr int fewPieces = 4;

bool isBox(const BodySettings& body)
{
  return !body.isRigid && body.shape.get<std::string>("Type") == "Box";
}

/// The cells of a box in each direction, with its Refine.
std::vector<int> cellsAsked(const Params& mesh)
{
  std::vector<int> cells = mesh.get<std::vector<int>>("Cells");
  const int most = std::numeric_limits<int>::max() >> halvingsOf(mesh);
  for (int& number : cells)
    number = std::clamp(number, 0, most) << halvingsOf(mesh);
  return cells;
}

/// The cells of a box in each direction if none is longer than `size`; never more than the deck asks for.
std::vector<int> cellsOfSize(const Params& mesh, double size)
{
  const auto lower = mesh.get<std::vector<double>>("Lower"), upper = mesh.get<std::vector<double>>("Upper");
  std::vector<int> cells = cellsAsked(mesh);
  for (std::size_t d = 0; d < cells.size(); ++d)
    cells[d] = std::min(cells[d], std::max(1, int(std::ceil((upper[d] - lower[d]) / size * (1.0 - 1e-9)))));
  return cells;
}

constexpr const char* unaskedPart = "between grid lines";

/// Cuts a side where grid lines must be; readCoarse() takes the parts out again.
void addStations(DeckList& box, const Stations& stations, Diagnostics& diagnostics)
{
  for (std::size_t d = 0; d < stations.size(); ++d) {
    if (stations[d].empty())
      continue;
    const std::string direction = d == 0 ? "X" : "Y", list = "Splits/grid lines of neighbours, " + direction;
    std::vector<std::string> names;
    for (std::size_t k = 0; k <= stations[d].size(); ++k)
      names.push_back(fmt::format("{} {} {}", unaskedPart, direction, k));
    applySetting(box, fmt::format("{}/Side={}", list, d == 0 ? "bottom" : "left"), diagnostics);
    applySetting(box, fmt::format("{}/At={{{:.17g}}}", list, fmt::join(stations[d], ", ")), diagnostics);
    applySetting(box, fmt::format("{}/Names={{{}}}", list, fmt::join(names, ", ")), diagnostics);
  }
}

Params boxWith(const std::vector<int>& cells, const Stations& stations, const Params& mesh,
               const SceneComponents& components)
{
  ListSpec spec;
  spec.name = mesh.name();
  spec.choices = components.meshSources.choices();
  Diagnostics diagnostics;
  DeckList list = parseDeck(toXml(mesh), mesh.path());
  applySetting(list, fmt::format("Cells={{{}}}", fmt::join(cells, ", ")), diagnostics);
  applySetting(list, "Refine=0", diagnostics);
  addStations(list, stations, diagnostics);
  Params coarser = validate(list, spec, diagnostics);
  diagnostics.throwIfAny();
  return coarser;
}

bool hasRoomForSplits(const Params& box, const SceneComponents& components)
{
  try {
    components.meshSources.build(box);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

/// A box whose cells are not longer than `size`, with more of them in a direction whose splits need more.
Params coarseBox(const Params& mesh, const Stations& stations, const SceneComponents& components, double size)
{
  const auto asked = cellsAsked(mesh);
  std::vector<int> cells = cellsOfSize(mesh, size);
  while (cells != asked) {
    if (Params box = boxWith(cells, stations, mesh, components); hasRoomForSplits(box, components))
      return box;
    for (std::size_t d = 0; d < cells.size(); ++d) {
      std::vector<int> more = cells;
      more[d] = std::min(cells[d] + 1, asked[d]);
      if (Params box = boxWith(more, stations, mesh, components); hasRoomForSplits(box, components))
        return box;
    }
    for (std::size_t d = 0; d < cells.size(); ++d)
      cells[d] = std::min(cells[d] + 1, asked[d]);
  }
  return mesh;
}

GivenMesh readCoarse(const BodySettings& body, const Stations& stations, const SceneComponents& components,
                     const Comm& comm, ScriptMeshes& scripts, double size)
{
  if (body.isRigid)
    return Mesh();
  const Params& mesh = body.shape;
  const Params chosen = isBox(body) ? coarseBox(mesh, stations, components, size) : mesh;
  GivenMesh read = readShared(*components.meshSources.build(chosen), comm, scripts);
  const auto isUnasked = [](const Side& side) { return side.name.rfind(unaskedPart, 0) == 0; };
  std::vector<Side>& sides = read.mesh.sides;
  sides.erase(std::remove_if(sides.begin(), sides.end(), isUnasked), sides.end());
  return read;
}

/// Of all boxes.
struct BoxEdges
{
  double longest = 0.0, shortest = std::numeric_limits<double>::infinity();
  std::size_t dim = 0;
};

BoxEdges boxEdges(const SceneSettings& scene)
{
  BoxEdges edges;
  for (const BodySettings& body : scene.bodies)
    if (isBox(body)) {
      const Params& mesh = body.shape;
      const auto lower = mesh.get<std::vector<double>>("Lower"), upper = mesh.get<std::vector<double>>("Upper");
      edges.dim = std::min(lower.size(), upper.size());
      for (std::size_t d = 0; d < edges.dim; ++d) {
        edges.longest = std::max(edges.longest, upper[d] - lower[d]);
        edges.shortest = std::min(edges.shortest, upper[d] - lower[d]);
      }
    }
  return edges;
}

/// How many cells the longest edge has at first. Stretched triangles are mended when they are halved, stretched
/// tetrahedra only in part (2 : 1 costs half as many dofs again): in space cells begin as cubes as far as few are
/// enough for that.
int firstPieces(const BoxEdges& edges, int most)
{
  if (edges.dim != 3)
    return 1;
  const double cubes = std::min(2.0 * fewPieces, edges.longest / edges.shortest * (1.0 - 1e-9));
  return std::clamp(int(std::ceil(cubes)), 1, std::max(1, most - 1));
}

int mostCells(const SceneSettings& scene)
{
  int most = 0;
  for (const BodySettings& body : scene.bodies)
    if (isBox(body))
      for (const int cells : cellsAsked(body.shape))
        most = std::max(most, cells);
  return most;
}

/// Sides that match cost less than those that are cut.
enum class Sides
{
  Match,
  MayBeCut
};

bool fits(const SceneSettings& scene, const SceneComponents& components, const MeshOfBody& meshes, Sides sides)
{
  try {
    const Model model = buildModel(scene, components, meshes);
    return sides == Sides::MayBeCut ||
           std::none_of(model.interfaces.begin(), model.interfaces.end(), [](const auto& i) { return i.isCut; });
  } catch (const InputError&) {
    return false;
  }
}

} // namespace

MeshOfBody coarsestMeshes(const SceneSettings& scene, const SceneComponents& components, const Comm& comm,
                          Ledger& ledger)
{
  const auto scripts = std::make_shared<ScriptMeshes>(ledger); // of all tries
  const BoxEdges edges = boxEdges(scene);
  const int most = mostCells(scene), coarsest = firstPieces(edges, most);
  const auto tryPieces = [&](int first, int end, const std::map<std::string, Stations>& stations,
                             Sides sides = Sides::Match) -> MeshOfBody {
    for (int pieces = first; pieces < end; ++pieces) {
      const double size = edges.longest / pieces;
      MeshOfBody meshes = [&components, &comm, scripts, size, stations](const BodySettings& body) -> GivenMesh {
        const auto found = stations.find(body.name);
        const Stations lines = found == stations.end() ? Stations() : found->second;
        return readCoarse(body, lines, components, comm, *scripts, size);
      };
      if (fits(scene, components, meshes, sides))
        return meshes;
    }
    return {};
  };
  // Even grids are better shaped; where sides are cut so that only fine ones match, grid lines go on across bodies.
  if (MeshOfBody even = tryPieces(coarsest, std::min(most, std::max(coarsest, fewPieces) + 1), {}))
    return even;
  if (MeshOfBody uneven = tryPieces(1, most, matchingStations(scene)))
    return uneven;
  if (MeshOfBody fine = tryPieces(fewPieces + 1, most, {}))
    return fine;
  return tryPieces(1, most, {}, Sides::MayBeCut);
}

} // namespace ndframe

#include "match_sides.hpp"

#include <fmt/format.h>

#include "cut_meshes.hpp"

namespace ndframe
{
namespace
{

/// What of a scene pairs sides.
struct Sides
{
  const Params& deck;
  const SceneComponents& components;
  const std::vector<InterfaceMesh>& earlier;
  std::vector<CutMesh>& meshes;
};

int bodyNumber(const std::vector<Params>& bodies, const std::string& name)
{
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (bodies[b].name() == name)
      return int(b);
  return -1;
}

std::shared_ptr<const SideMap> earlierMap(const std::string& name, const std::vector<InterfaceMesh>& earlier)
{
  for (const InterfaceMesh& before : earlier)
    if (before.name == name)
      return before.map;
  return nullptr;
}

FacingSides sidesOf(const Params& definition, const std::vector<Params>& bodies)
{
  return {bodyNumber(bodies, definition.get<std::string>("Dirichlet Body")),
          bodyNumber(bodies, definition.get<std::string>("Neumann Body")),
          definition.get<std::string>("Dirichlet Side"),
          definition.has("Neumann Side") ? definition.get<std::string>("Neumann Side") : definition.name(),
          {},
          false};
}

bool isSolid(const FacingSides& sides, const std::vector<CutMesh>& meshes)
{
  return meshes[std::size_t(sides.firstBody)].mesh.dim == 3;
}

bool bothExist(const FacingSides& sides, const std::vector<CutMesh>& meshes)
{
  return meshes[std::size_t(sides.firstBody)].mesh.findSide(sides.firstSide) != nullptr &&
         meshes[std::size_t(sides.secondBody)].mesh.findSide(sides.secondSide) != nullptr;
}

/// Whether the sides of two solids do not have the same facets.
bool haveOtherFacets(const FacingSides& sides, const std::vector<CutMesh>& meshes)
{
  const Mesh &first = meshes[std::size_t(sides.firstBody)].mesh, &second = meshes[std::size_t(sides.secondBody)].mesh;
  return first.dim == 3 && second.dim == 3 && bothExist(sides, meshes) &&
         !sidesMatch(first, *first.findSide(sides.firstSide), second, *second.findSide(sides.secondSide));
}

/// The map of an interface whose sides exist and do not match.
std::shared_ptr<const SideMap> mapOf(const Params& definition, const FacingSides& sides,
                                     const std::vector<InterfaceMesh>& earlier, const std::vector<CutMesh>& meshes)
{
  const Mesh &first = meshes[std::size_t(sides.firstBody)].mesh, &second = meshes[std::size_t(sides.secondBody)].mesh;
  const Side *ours = first.findSide(sides.firstSide), *theirs = second.findSide(sides.secondSide);
  if (ours == nullptr || theirs == nullptr || first.dim != 2 || second.dim != 2)
    return nullptr;
  if (auto before = earlierMap(definition.name(), earlier);
      before && !facingPieces(*before, first, ours->facets, second, theirs->facets).empty())
    return before;
  if (sidesMatch(first, *ours, second, *theirs))
    return nullptr;
  return mapBetween(sides, first, second, definition.get<double>("Corner Angle"));
}

/// Whether a map of earlier meshes still is one of this side.
bool suits(const std::shared_ptr<const SideMap>& map, const Mesh& mesh, const Side& side)
{
  return map && map->first().locate(mesh, side.facets.front()).edge >= 0;
}

Diagnostic facesNothing(const Params& definition, const std::string& side)
{
  return definition.mistake(
      "", fmt::format(
              "no part of side \"{}\" faces the rigid body: along the side's outward normal no part of it faces back.",
              side));
}

/// The pairing of a solid's side with a rigid body, which gets its layer unless it has one.
SidePairing surfacePairing(Mesh& rigid, bool isMeshed, const Params& definition, const Obstacle& obstacle,
                           const Mesh& first, const Side& side)
{
  SidePairing pairing;
  pairing.surface = obstacle.facing(first, side.facets);
  if (pairing.surface->facets.empty())
    throw InputError(facesNothing(definition, side.name));
  if (!isMeshed)
    addLayer(rigid, definition.name(), first, *pairing.surface);
  return pairing;
}

/// The same for a side that faces a rigid body; the body gets its strip unless it has one.
SidePairing obstaclePairing(const Sides& scene, const Params& definition, const Params& rigid, bool isMeshed,
                            const FacingSides& sides)
{
  const Mesh& first = scene.meshes[std::size_t(sides.firstBody)].mesh;
  const Side* ours = first.findSide(sides.firstSide);
  if (ours == nullptr)
    throw InputError(definition.mistake(
        "Dirichlet Side", fmt::format("there is no side \"{}\"; {}.", sides.firstSide, sideNames(first))));
  const auto obstacle = scene.components.obstacles.build(rigid);
  if (first.dim == 3)
    return surfacePairing(scene.meshes[std::size_t(sides.secondBody)].mesh, isMeshed, definition, *obstacle, first,
                          *ours);
  auto map = earlierMap(definition.name(), scene.earlier);
  if (!suits(map, first, *ours)) {
    SidePolygon side(first, ours->facets, definition.get<double>("Corner Angle"));
    SidePolygon outline = obstacle->facing(side).polygon;
    map = std::make_shared<const SideMap>(std::move(side), std::move(outline));
  }
  if (map->segments().empty())
    throw InputError(facesNothing(definition, sides.firstSide));
  if (!isMeshed)
    addStrip(scene.meshes[std::size_t(sides.secondBody)].mesh, definition.name(), *map, first, ours->facets);
  return {map, obstacle->facing(map->first()).gap, {}, false};
}

/// A rigid body is the second one, has no sides of its own and touches something.
void checkRigid(const Params& deck, const std::vector<Params>& bodies)
{
  std::map<std::string, bool> isTouched;
  for (const Params& definition : deck.sub("Interfaces").subs()) {
    const int first = bodyNumber(bodies, definition.get<std::string>("Dirichlet Body")),
              second = bodyNumber(bodies, definition.get<std::string>("Neumann Body"));
    if (first >= 0 && bodies[std::size_t(first)].hasSub("Rigid"))
      throw InputError(definition.mistake("Dirichlet Body", fmt::format("\"{}\" is rigid: name it as Neumann Body, and "
                                                                        "the one that touches it here.",
                                                                        bodies[std::size_t(first)].name())));
    if (second < 0 || !bodies[std::size_t(second)].hasSub("Rigid"))
      continue;
    if (definition.has("Neumann Side"))
      throw InputError(definition.mistake("Neumann Side", fmt::format("\"{}\" is rigid and has no sides; remove this.",
                                                                      bodies[std::size_t(second)].name())));
    isTouched[bodies[std::size_t(second)].name()] = true;
  }
  for (const Params& body : bodies)
    if (body.hasSub("Rigid") && !isTouched[body.name()])
      throw InputError(body.mistake("", "is rigid, and nothing touches it; name it in an interface as Neumann Body."));
}

/// Sides in the plane that match as they are, by the interface.
using MatchingSides = std::vector<std::pair<Params, FacingSides>>;

/// Cells that are halved for one side may have a facet on another one, which does not match any more then: those that
/// do not get a map and a place among the facing sides. False where all do.
bool faceWhereCut(const std::vector<Mesh>& before, const std::vector<DerivedMesh>& cut, MatchingSides& matching,
                  std::vector<FacingSides>& facing, std::map<std::string, SidePairing>& pairings)
{
  bool any = false;
  for (auto& [definition, sides] : matching) {
    const Mesh &first = cut[std::size_t(sides.firstBody)].mesh, &second = cut[std::size_t(sides.secondBody)].mesh;
    if (sides.map || sidesMatch(first, *first.findSide(sides.firstSide), second, *second.findSide(sides.secondSide)))
      continue;
    sides.map = mapBetween(sides, before[std::size_t(sides.firstBody)], before[std::size_t(sides.secondBody)],
                           definition.get<double>("Corner Angle"));
    pairings[definition.name()].map = sides.map;
    facing.push_back(sides);
    any = true;
  }
  return any;
}

/// The meshes as they were get a place beside those that match. isFirst: the meshes are not made of earlier ones.
void insertAll(std::vector<CutMesh>& meshes, std::vector<FacingSides> facing, MatchingSides matching,
               const Params& deck, bool isFirst, std::map<std::string, SidePairing>& pairings)
{
  std::vector<char> isRigid;
  for (const Params& body : deck.sub("Bodies").subs())
    isRigid.push_back(body.hasSub("Rigid"));
  std::vector<Mesh> before;
  for (const CutMesh& mesh : meshes)
    before.push_back(mesh.mesh);
  if (isFirst || facing.front().map) {
    const auto changed = addSideEnds(before, facing, isRigid, deck.hasSub("Accuracy"));
    for (std::size_t b = 0; b < meshes.size(); ++b)
      if (changed[b]) {
        meshes[b].mesh = before[b];
        meshes[b].nodes = {};
      }
  }
  std::vector<DerivedMesh> cut = cutMeshes(before, facing, deck.sub("Interfaces"));
  while (faceWhereCut(before, cut, matching, facing, pairings))
    cut = cutMeshes(before, facing, deck.sub("Interfaces"));
  for (std::size_t b = 0; b < meshes.size(); ++b)
    if (!cut[b].parents.empty()) {
      meshes[b].base = std::move(before[b]);
      meshes[b].mesh = std::move(cut[b].mesh);
      meshes[b].parents = std::move(cut[b].parents);
      meshes[b].uncutPoints = cut[b].uncutPoints;
      meshes[b].nodes = {};
    }
}

/// Solids and rigid bodies: their layers lie on the facets of the solids as they are now.
void pairSurfaces(const Sides& scene, const std::vector<Params>& bodies, const std::vector<char>& isMeshed,
                  std::map<std::string, SidePairing>& pairings)
{
  for (const Params& definition : scene.deck.sub("Interfaces").subs()) {
    const FacingSides sides = sidesOf(definition, bodies);
    if (sides.firstBody < 0 || sides.secondBody < 0 || !isSolid(sides, scene.meshes))
      continue;
    const Params& second = bodies[std::size_t(sides.secondBody)];
    if (second.hasSub("Rigid"))
      pairings[definition.name()] =
          obstaclePairing(scene, definition, second.sub("Rigid"), isMeshed[std::size_t(sides.secondBody)] != 0, sides);
  }
}

} // namespace

std::map<std::string, SidePairing> matchSides(const Params& deck, const SceneComponents& components,
                                              const std::vector<InterfaceMesh>& earlier, std::vector<CutMesh>& meshes)
{
  const Sides scene{deck, components, earlier, meshes};
  const auto bodies = deck.sub("Bodies").subs();
  checkRigid(deck, bodies);
  std::vector<char> isMeshed;
  for (const CutMesh& mesh : meshes)
    isMeshed.push_back(mesh.mesh.numCells() > 0);
  std::map<std::string, SidePairing> pairings;
  std::vector<FacingSides> facing;
  MatchingSides matching;
  bool isCut = false;
  for (const Params& definition : deck.sub("Interfaces").subs()) {
    FacingSides sides = sidesOf(definition, bodies);
    SidePairing& pairing = pairings[definition.name()];
    if (sides.firstBody < 0 || sides.secondBody < 0)
      continue;
    const Params& second = bodies[std::size_t(sides.secondBody)];
    if (!second.hasSub("Rigid"))
      pairing = {mapOf(definition, sides, earlier, meshes), {}, {}, haveOtherFacets(sides, meshes)};
    else if (!isSolid(sides, meshes))
      pairing =
          obstaclePairing(scene, definition, second.sub("Rigid"), isMeshed[std::size_t(sides.secondBody)] != 0, sides);
    sides.map = pairing.map;
    sides.isCut = pairing.isCut;
    isCut = isCut || pairing.map || pairing.isCut;
    const bool areMeshed = !second.hasSub("Rigid") && bothExist(sides, meshes);
    if (sides.map || (areMeshed && isSolid(sides, meshes)))
      facing.push_back(std::move(sides));
    else if (areMeshed)
      matching.emplace_back(definition, std::move(sides));
  }
  if (isCut)
    insertAll(meshes, std::move(facing), std::move(matching), deck, earlier.empty(), pairings);
  pairSurfaces(scene, bodies, isMeshed, pairings);
  return pairings;
}

} // namespace ndframe

#include "match_sides.hpp"

#include <fmt/format.h>

#include "drawn_sides.hpp"

namespace ndframe
{
namespace
{

/// What of a scene pairs sides.
struct Sides
{
  const SceneSettings& settings;
  const SceneComponents& components;
  const std::vector<InterfaceMesh>& earlier;
  std::vector<CutMesh>& meshes;
};

int bodyNumber(const std::vector<BodySettings>& bodies, const std::string& name)
{
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (bodies[b].name == name)
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

FacingSides sidesOf(const InterfaceSettings& interface, const std::vector<BodySettings>& bodies)
{
  return {bodyNumber(bodies, interface.dirichletBody),
          bodyNumber(bodies, interface.neumannBody),
          interface.dirichletSide,
          interface.neumannSide.value_or(interface.name),
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
std::shared_ptr<const SideMap> mapOf(const InterfaceSettings& interface, const FacingSides& sides,
                                     const std::vector<InterfaceMesh>& earlier, const std::vector<CutMesh>& meshes)
{
  const Mesh &first = meshes[std::size_t(sides.firstBody)].mesh, &second = meshes[std::size_t(sides.secondBody)].mesh;
  const Side *ours = first.findSide(sides.firstSide), *theirs = second.findSide(sides.secondSide);
  if (ours == nullptr || theirs == nullptr || first.dim != 2 || second.dim != 2)
    return nullptr;
  if (auto before = earlierMap(interface.name, earlier);
      before && !facingPieces(*before, first, ours->facets, second, theirs->facets).empty())
    return before;
  const bool match = sidesMatch(first, *ours, second, *theirs);
  if (match && matchAsDrawn(sides, meshes))
    return nullptr;
  auto map = mapAsDrawn(sides, meshes, first, second, interface.cornerAngle);
  return match && !turns(*map) ? nullptr : map;
}

/// The pairing of two bodies that are not rigid.
SidePairing pairingOf(const InterfaceSettings& interface, const FacingSides& sides,
                      const std::vector<InterfaceMesh>& earlier, const std::vector<CutMesh>& meshes)
{
  SidePairing pairing;
  pairing.map = mapOf(interface, sides, earlier, meshes);
  pairing.isCut = haveOtherFacets(sides, meshes);
  const bool areAlike = meshes[std::size_t(sides.firstBody)].mesh.dim == meshes[std::size_t(sides.secondBody)].mesh.dim;
  if (!pairing.map && areAlike && bothExist(sides, meshes))
    pairing.drawn = firstSideAsDrawn(sides, meshes, interface.cornerAngle);
  return pairing;
}

/// Whether a map of earlier meshes still is one of this side.
bool suits(const std::shared_ptr<const SideMap>& map, const Mesh& mesh, const Side& side)
{
  return map && map->first().locate(mesh, side.facets.front()).edge >= 0;
}

Diagnostic facesNothing(const InterfaceSettings& interface, const std::string& side)
{
  return interface.place.mistake(
      "", fmt::format(
              "no part of side \"{}\" faces the rigid body: along the side's outward normal no part of it faces back.",
              side));
}

/// The pairing of a solid's side with a rigid body, which gets its layer unless it has one.
SidePairing surfacePairing(Mesh& rigid, bool isMeshed, const InterfaceSettings& interface, const Obstacle& obstacle,
                           const Mesh& first, const Side& side)
{
  SidePairing pairing;
  pairing.surface = obstacle.facing(first, side.facets);
  if (pairing.surface->facets.empty())
    throw InputError(facesNothing(interface, side.name));
  if (!isMeshed)
    addLayer(rigid, interface.name, first, *pairing.surface);
  return pairing;
}

/// The same for a side that faces a rigid body; the body gets its strip unless it has one.
SidePairing obstaclePairing(const Sides& scene, const InterfaceSettings& interface, const Params& surface,
                            bool isMeshed, const FacingSides& sides)
{
  const CutMesh& body = scene.meshes[std::size_t(sides.firstBody)];
  const Mesh& first = body.mesh;
  const Side* ours = first.findSide(sides.firstSide);
  if (ours == nullptr)
    throw InputError(interface.place.mistake(
        "Dirichlet Side", fmt::format("there is no side \"{}\"; {}.", sides.firstSide, sideNames(first))));
  const auto obstacle = scene.components.obstacles.build(surface);
  if (first.dim == 3)
    return surfacePairing(scene.meshes[std::size_t(sides.secondBody)].mesh, isMeshed, interface, *obstacle, first,
                          *ours);
  auto map = earlierMap(interface.name, scene.earlier);
  if (!suits(map, first, *ours)) {
    SidePolygon side = polygonAsDrawn(body, first, sides.firstSide, interface.cornerAngle);
    SidePolygon outline = obstacle->facing(side).polygon;
    map = std::make_shared<const SideMap>(std::move(side), std::move(outline));
  }
  if (map->segments().empty())
    throw InputError(facesNothing(interface, sides.firstSide));
  if (!isMeshed)
    addStrip(scene.meshes[std::size_t(sides.secondBody)].mesh, interface.name, *map, first, ours->facets);
  return {map, obstacle->facing(map->first()).gap};
}

/// A rigid body is the second one, has no sides of its own and touches something.
void checkRigid(const SceneSettings& scene)
{
  const std::vector<BodySettings>& bodies = scene.bodies;
  std::map<std::string, bool> isTouched;
  for (const InterfaceSettings& interface : scene.interfaces) {
    const int first = bodyNumber(bodies, interface.dirichletBody), second = bodyNumber(bodies, interface.neumannBody);
    if (first >= 0 && bodies[std::size_t(first)].isRigid)
      throw InputError(
          interface.place.mistake("Dirichlet Body", fmt::format("\"{}\" is rigid: name it as Neumann Body, and "
                                                                "the one that touches it here.",
                                                                bodies[std::size_t(first)].name)));
    if (second < 0 || !bodies[std::size_t(second)].isRigid)
      continue;
    if (interface.neumannSide)
      throw InputError(
          interface.place.mistake("Neumann Side", fmt::format("\"{}\" is rigid and has no sides; remove this.",
                                                              bodies[std::size_t(second)].name)));
    isTouched[bodies[std::size_t(second)].name] = true;
  }
  for (const BodySettings& body : bodies)
    if (body.isRigid && !isTouched[body.name])
      throw InputError(
          body.place.mistake("", "is rigid, and nothing touches it; name it in an interface as Neumann Body."));
}

/// Sides in the plane that match as they are, by the interface.
using MatchingSides = std::vector<std::pair<InterfaceSettings, FacingSides>>;

/// Cells that are halved for one side may have a facet on another one, which does not match any more then: those that
/// do not get a map and a place among the facing sides. False where all do.
bool faceWhereCut(const std::vector<CutMesh>& meshes, const std::vector<Mesh>& before,
                  const std::vector<DerivedMesh>& cut, MatchingSides& matching, std::vector<FacingSides>& facing,
                  std::map<std::string, SidePairing>& pairings)
{
  bool any = false;
  for (auto& [interface, sides] : matching) {
    const Mesh &first = cut[std::size_t(sides.firstBody)].mesh, &second = cut[std::size_t(sides.secondBody)].mesh;
    if (sides.map || sidesMatch(first, *first.findSide(sides.firstSide), second, *second.findSide(sides.secondSide)))
      continue;
    sides.map = mapAsDrawn(sides, meshes, before[std::size_t(sides.firstBody)], before[std::size_t(sides.secondBody)],
                           interface.cornerAngle);
    pairings[interface.name].map = sides.map;
    facing.push_back(sides);
    any = true;
  }
  return any;
}

/// The meshes as they were get a place beside those that match. isFirst: the meshes are not made of earlier ones.
void insertAll(std::vector<CutMesh>& meshes, std::vector<FacingSides> facing, MatchingSides matching,
               const SceneSettings& scene, bool isFirst, std::map<std::string, SidePairing>& pairings)
{
  std::vector<char> isRigid;
  for (const BodySettings& body : scene.bodies)
    isRigid.push_back(body.isRigid);
  std::vector<Mesh> before;
  for (const CutMesh& mesh : meshes)
    before.push_back(mesh.mesh);
  if (isFirst || facing.front().map) {
    const auto changed = addSideEnds(before, facing, isRigid, scene.hasTarget);
    for (std::size_t b = 0; b < meshes.size(); ++b)
      if (changed[b]) {
        meshes[b].mesh = before[b];
        meshes[b].nodes = {};
      }
  }
  std::vector<DerivedMesh> cut = cutMeshes(before, facing, scene.interfacesPlace);
  while (faceWhereCut(meshes, before, cut, matching, facing, pairings))
    cut = cutMeshes(before, facing, scene.interfacesPlace);
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
void pairSurfaces(const Sides& scene, const std::vector<char>& isMeshed, std::map<std::string, SidePairing>& pairings)
{
  for (const InterfaceSettings& interface : scene.settings.interfaces) {
    const FacingSides sides = sidesOf(interface, scene.settings.bodies);
    if (sides.firstBody < 0 || sides.secondBody < 0 || !isSolid(sides, scene.meshes))
      continue;
    const BodySettings& second = scene.settings.bodies[std::size_t(sides.secondBody)];
    if (second.isRigid)
      pairings[interface.name] =
          obstaclePairing(scene, interface, second.shape, isMeshed[std::size_t(sides.secondBody)] != 0, sides);
  }
}

/// The pairings of solids of which ranks have shares: their meshes have been cut.
std::map<std::string, SidePairing> toldPairings(const Sides& scene, const std::vector<char>& isMeshed,
                                                const ToldScene& told)
{
  std::map<std::string, SidePairing> pairings;
  for (std::size_t i = 0; i < told.areCut.size(); ++i)
    pairings[scene.settings.interfaces[i].name].isCut = told.areCut[i] != 0;
  pairSurfaces(scene, isMeshed, pairings);
  return pairings;
}

} // namespace

std::map<std::string, SidePairing> matchSides(const SceneSettings& settings, const SceneComponents& components,
                                              const std::vector<InterfaceMesh>& earlier, std::vector<CutMesh>& meshes,
                                              const ToldScene* told)
{
  const Sides scene{settings, components, earlier, meshes};
  checkRigid(settings);
  std::vector<char> isMeshed;
  for (const CutMesh& mesh : meshes)
    isMeshed.push_back(mesh.mesh.numCells() > 0);
  if (told != nullptr)
    return toldPairings(scene, isMeshed, *told);
  std::map<std::string, SidePairing> pairings;
  std::vector<FacingSides> facing;
  MatchingSides matching;
  bool isCut = false;
  for (const InterfaceSettings& interface : settings.interfaces) {
    FacingSides sides = sidesOf(interface, settings.bodies);
    SidePairing& pairing = pairings[interface.name];
    if (sides.firstBody < 0 || sides.secondBody < 0)
      continue;
    const BodySettings& second = settings.bodies[std::size_t(sides.secondBody)];
    if (!second.isRigid)
      pairing = pairingOf(interface, sides, earlier, meshes);
    else if (!isSolid(sides, meshes))
      pairing = obstaclePairing(scene, interface, second.shape, isMeshed[std::size_t(sides.secondBody)] != 0, sides);
    sides.map = pairing.map;
    sides.isCut = pairing.isCut;
    isCut = isCut || pairing.map || pairing.isCut;
    const bool areMeshed = !second.isRigid && bothExist(sides, meshes);
    if (sides.map || (areMeshed && isSolid(sides, meshes)))
      facing.push_back(std::move(sides));
    else if (areMeshed)
      matching.emplace_back(interface, std::move(sides));
  }
  if (isCut)
    insertAll(meshes, std::move(facing), std::move(matching), settings, earlier.empty(), pairings);
  pairSurfaces(scene, isMeshed, pairings);
  return pairings;
}

} // namespace ndframe

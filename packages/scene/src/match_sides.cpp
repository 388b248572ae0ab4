#include "match_sides.hpp"

#include "ndframe/interface/insertion.hpp"

namespace ndframe
{
namespace
{

int bodyNumber(const Params& deck, const std::string& name)
{
  const auto bodies = deck.sub("Bodies").subs();
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
  const double angle = definition.get<double>("Corner Angle");
  return std::make_shared<const SideMap>(SidePolygon(first, ours->facets, angle),
                                         SidePolygon(second, theirs->facets, angle));
}

} // namespace

std::map<std::string, std::shared_ptr<const SideMap>>
matchSides(const Params& deck, const std::vector<InterfaceMesh>& earlier, std::vector<CutMesh>& meshes)
{
  std::map<std::string, std::shared_ptr<const SideMap>> maps;
  std::vector<FacingSides> facing;
  for (const Params& definition : deck.sub("Interfaces").subs()) {
    FacingSides sides{bodyNumber(deck, definition.get<std::string>("Dirichlet Body")),
                      bodyNumber(deck, definition.get<std::string>("Neumann Body")),
                      definition.get<std::string>("Dirichlet Side"),
                      definition.get<std::string>("Neumann Side"),
                      {}};
    if (sides.firstBody >= 0 && sides.secondBody >= 0 && sides.firstBody != sides.secondBody)
      sides.map = mapOf(definition, sides, earlier, meshes);
    maps[definition.name()] = sides.map;
    if (sides.map)
      facing.push_back(std::move(sides));
  }
  if (facing.empty())
    return maps;
  std::vector<Mesh> before;
  for (const CutMesh& mesh : meshes)
    before.push_back(mesh.mesh);
  std::vector<DerivedMesh> cut = insertion(before, facing);
  for (std::size_t b = 0; b < meshes.size(); ++b)
    if (!cut[b].parents.empty()) {
      meshes[b].base = std::move(before[b]);
      meshes[b].mesh = std::move(cut[b].mesh);
      meshes[b].parents = std::move(cut[b].parents);
      meshes[b].nodes = {};
    }
  return maps;
}

} // namespace ndframe

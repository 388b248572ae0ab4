#include "ndframe/scene/shared_scene.hpp"

namespace ndframe
{
namespace
{

/// The number of a drawn vertex (twice), or of the middle of a drawn edge, among the nodes of the refined mesh.
std::int64_t refinedNumber(const DrawnScene& drawn, std::size_t body, const std::array<int, 2>& ends)
{
  const RefinedNumbers& numbers = drawn.numbers[body];
  const auto [a, b] = ends;
  DrawnPlace place = DrawnPlace::middle(DrawnPlace::vertex(a), DrawnPlace::vertex(b));
  if (drawn.halvings[body] == 0)
    return a == b ? numbers.point(DrawnPlace::vertex(a)) : numbers.middle(place);
  for (int k = 1; k < drawn.halvings[body]; ++k)
    place = place.doubled();
  return numbers.point(place);
}

/// The first sides of interfaces between bodies that have been or will be halved, by name, as drawn: they have the
/// directions of contact.
std::vector<InterfaceMesh> sidesAsDrawn(const DrawnScene& drawn)
{
  const auto isHalved = [&](const InterfaceSide& side) { return drawn.asked[std::size_t(side.body)] > 0; };
  std::vector<InterfaceMesh> sides;
  for (const InterfaceMesh& interface : drawn.model->interfaces) {
    if (!isHalved(interface.dirichlet()) && !isHalved(interface.neumann()))
      continue;
    const InterfaceMesh& first = interface.firstMesh ? *interface.firstMesh : interface;
    InterfaceMesh side;
    side.name = interface.name;
    side.dim = first.dim;
    side.points = first.points;
    side.facets = first.facets;
    side.measures = first.measures;
    side.endNormals = first.endNormals;
    sides.push_back(std::move(side));
  }
  return sides;
}

/// How many cells regions have, by those of each kind.
void countCells(std::vector<BodyRegion>& regions, const BodyModel& body, const std::vector<std::int64_t>& cellsOfKinds)
{
  std::vector<int> regionOfKind(cellsOfKinds.size(), -1);
  for (std::size_t cell = 0; cell < body.regionOfCell.size(); ++cell)
    regionOfKind[std::size_t(body.mesh.groups.kind[cell])] = body.regionOfCell[cell];
  for (std::size_t r = 0; r < regions.size(); ++r) {
    regions[r].numCells = 0;
    for (std::size_t kind = 0; kind < cellsOfKinds.size(); ++kind)
      regions[r].numCells += regionOfKind[kind] == int(r) ? cellsOfKinds[kind] : 0;
  }
}

} // namespace

ToldScene told(const DrawnScene& drawn)
{
  ToldScene scene = told(*drawn.model);
  scene.halvings = drawn.asked;
  scene.areRead = !drawn.inside.empty();
  scene.sides = sidesAsDrawn(drawn);
  for (std::size_t b = 0; b < drawn.inside.size(); ++b) {
    scene.outlines[b].measure = drawn.inside[b].measure;
    countCells(scene.regions[b], drawn.model->bodies[b], drawn.inside[b].cellsOfKinds);
  }
  for (std::size_t b = 0; b < scene.regions.size(); ++b) {
    const BodyModel& body = drawn.model->bodies[b];
    for (BodyRegion& region : scene.regions[b])
      region.numCells <<= body.mesh.dim * drawn.halvings[b];
    for (std::size_t s = 0; s < body.supports.size() && !body.isRigid; ++s)
      if (const Support& support = *body.supports[s]; support.holdsPoint() || support.holdsMeanMotion())
        for (const NodeConstraint& pin : support.constraints(body.mesh, body.nodes))
          scene.pins.push_back(
              {int(b), int(s), refinedNumber(drawn, b, body.nodes.ends(pin.node)), pin.direction, pin.value});
  }
  return scene;
}

} // namespace ndframe

#include "drawn_sides.hpp"

#include <algorithm>

#include "ndframe/interface/normal_field.hpp"

namespace ndframe
{
namespace
{

const Mesh& asDrawn(const CutMesh& body)
{
  return body.drawn ? *body.drawn : body.mesh;
}

bool areHalved(const FacingSides& sides, const std::vector<CutMesh>& meshes)
{
  return meshes[std::size_t(sides.firstBody)].drawn || meshes[std::size_t(sides.secondBody)].drawn;
}

bool turns(const SidePolygon& polygon)
{
  return std::any_of(polygon.edges().begin(), polygon.edges().end(), [](const SideEdge& edge) { return edge.turns; });
}

} // namespace

bool matchAsDrawn(const FacingSides& sides, const std::vector<CutMesh>& meshes)
{
  const Mesh &first = asDrawn(meshes[std::size_t(sides.firstBody)]),
             &second = asDrawn(meshes[std::size_t(sides.secondBody)]);
  return sidesMatch(first, *first.findSide(sides.firstSide), second, *second.findSide(sides.secondSide));
}

SidePolygon polygonAsDrawn(const CutMesh& body, const Mesh& mesh, const std::string& side, double cornerAngle)
{
  if (body.drawn) {
    SidePolygon drawn(*body.drawn, body.drawn->findSide(side)->facets, cornerAngle);
    if (turns(drawn))
      return drawn;
  }
  return {mesh, mesh.findSide(side)->facets, cornerAngle};
}

std::shared_ptr<const SideMap> mapAsDrawn(const FacingSides& sides, const std::vector<CutMesh>& meshes,
                                          const Mesh& first, const Mesh& second, double cornerAngle)
{
  return std::make_shared<const SideMap>(
      polygonAsDrawn(meshes[std::size_t(sides.firstBody)], first, sides.firstSide, cornerAngle),
      polygonAsDrawn(meshes[std::size_t(sides.secondBody)], second, sides.secondSide, cornerAngle));
}

bool turns(const SideMap& map)
{
  return turns(map.first()) || turns(map.second());
}

std::shared_ptr<const InterfaceMesh> firstSideAsDrawn(const FacingSides& sides, const std::vector<CutMesh>& meshes,
                                                      double cornerAngle)
{
  if (!areHalved(sides, meshes))
    return nullptr;
  const Mesh& first = asDrawn(meshes[std::size_t(sides.firstBody)]);
  const bool mayTurn = first.dim == 2 || matchAsDrawn(sides, meshes);
  return std::make_shared<const InterfaceMesh>(
      sideAlone(first, first.findSide(sides.firstSide)->facets, mayTurn ? cornerAngle : 0.0));
}

} // namespace ndframe

#include "cut_meshes.hpp"

#include <fmt/format.h>

#include "ndframe/cutting/cannot_cut.hpp"

namespace ndframe
{

std::shared_ptr<const SideMap> mapBetween(const FacingSides& sides, const Mesh& first, const Mesh& second,
                                          double cornerAngle)
{
  return std::make_shared<const SideMap>(SidePolygon(first, first.findSide(sides.firstSide)->facets, cornerAngle),
                                         SidePolygon(second, second.findSide(sides.secondSide)->facets, cornerAngle));
}

std::vector<DerivedMesh> cutMeshes(const std::vector<Mesh>& meshes, const std::vector<FacingSides>& facing,
                                   const ListPlace& list)
{
  try {
    return insertion(meshes, facing);
  } catch (const CannotCut& error) {
    throw InputError(list.mistake(
        "", fmt::format("sides of solids that were meshed independently cannot be cut to match ({}): give one of the "
                        "meshes another size, or mesh both bodies in one gmsh script with a common face.",
                        error.what())));
  }
}

} // namespace ndframe
